// The studio backdrop: lightest behind the body, without a horizon, because the ground only adds shadow.
uniform vec2 tile_origin_px;   // of this tile in the picture, from the lower left, in finished pixels
uniform vec2 picture_size_px;
uniform vec3 backdrop_centre;  // linear
uniform vec3 backdrop_edge;

vec3 backdrop(vec2 at_px) {
    vec2 place = (at_px + tile_origin_px) / picture_size_px - vec2(0.5, 0.56);
    place.x *= picture_size_px.x / picture_size_px.y;
    float away = length(place * vec2(1.0, 0.9));
    return mix(backdrop_centre, backdrop_edge, smoothstep(0.05, 0.85, away));
}
