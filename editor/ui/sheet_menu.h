#pragma once
// What a right click on the sheet offers: the actions that can be done with what is selected.
namespace selvedge {

struct Desk;

// Opens it at the cursor; what lies under the cursor is selected first unless it is already.
void open_sheet_menu(Desk& desk);

// Each frame: shows it as long as it is open.
void show_sheet_menu(Desk& desk);

}  // namespace selvedge
