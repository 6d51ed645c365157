#pragma once
// Opening, saving and leaving documents. What would lose work asks first, in a bar; what fails says so in words.
#include <string>

#include "editor/ui/services.h"

namespace selvedge {

struct Desk;

void new_document(Desk& desk);
void open_loaded(Desk& desk, PatternDocument source, const std::string& file);
void open_file(Desk& desk, const std::string& file);
void open_example(Desk& desk, const Example& example);
void recover_journal(Desk& desk, const LeftJournal& journal);

// A garment file is opened, a body is put on; anything else is said to be neither.
void take_dropped_file(Desk& desk, const std::string& file);

bool save(Desk& desk);  // asks for a name where there is none; false: not saved (yet)
void save_as(Desk& desk, const std::string& file);
void export_to(Desk& desk, const std::string& file);
void close(Desk& desk);

// What the browser is opened for.
void browse_to_open(Desk& desk);
void browse_to_save(Desk& desk);
void browse_to_export(Desk& desk, const std::string& ending);
void browse_for_body(Desk& desk);

// Asks about what earlier runs left.
void offer_recovery(Desk& desk);

// "tshirt.json", "untitled"
std::string document_name(const Desk& desk);

}  // namespace selvedge
