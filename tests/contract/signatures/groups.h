// No guard: included once a dialect, with DIALECT as its name. A function for each group of rows of
// checklist.txt.

namespace DIALECT {

void basics();
void enumerations();
void errors();
void geometry();
void geometryActions();
void appearance();
void appearanceActions();
void lookup();
void utilities();
void contradictions();

} // namespace DIALECT
