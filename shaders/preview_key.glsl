uniform vec3 to_key;
