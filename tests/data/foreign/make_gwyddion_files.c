/* Height fields saved by Gwyddion's own modules. Run by make_gwyddion_files.sh, which says how.
 * Usage: make_gwyddion_files FOLDER
 *
 * Beside the files it writes heights.csv, the numbers as the data field holds them: what a reader
 * must give back, to the last bit that a format keeps. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <libgwyddion/gwycontainer.h>
#include <libgwymodule/gwymodule-file.h>
#include <libgwymodule/gwymoduleloader.h>
#include <libprocess/datafield.h>

/* Of libgwyapp and GTK, whose headers need more than this program does. */
void gwy_app_init_nongui(const char* first_option, ...);
void gwy_app_data_browser_set_gui_enabled(gboolean enabled);
GwyContainer* gwy_app_settings_get(void);
void gwy_app_data_browser_add(GwyContainer* data);
void gwy_app_data_browser_select_data_field(GwyContainer* data, gint id);
gboolean gtk_init_check(int* argc, char*** argv);

enum { columns = 7, rows = 5 };

static const char* folder;

/* Negative, tiny, no short decimal, and two that float cannot tell apart. */
static double height_m(int row, int column) {
  const int i = columns * row + column;
  if (i == 0) return -1.0 / 3 * 1e-7;
  if (i == 1) return 4.9e-21;
  if (i == 2) return 1.0000000000000002e-7;
  if (i == 3) return 1e-7;
  if (i == 4) return 0;
  return (row * row * 1.7 - column * column * 0.9 + row * column / 7.0) * 1e-8;
}

static GwyDataField* field(double factor, const char* unit) {
  GwyDataField* field = gwy_data_field_new(columns, rows, 0.7e-6 / 3, 1.1e-6, FALSE);
  double* data = gwy_data_field_get_data(field);
  for (int i = 0; i < rows * columns; ++i) data[i] = factor * height_m(i / columns, i % columns);
  gwy_data_field_set_xoffset(field, 2e-6);
  gwy_data_field_set_yoffset(field, -3e-6);
  gwy_si_unit_set_from_string(gwy_data_field_get_si_unit_xy(field), "m");
  gwy_si_unit_set_from_string(gwy_data_field_get_si_unit_z(field), unit);
  return field;
}

static void add_channel(GwyContainer* data, int id, const char* title, GwyDataField* field) {
  char key[40];
  snprintf(key, sizeof key, "/%d/data", id);
  gwy_container_set_object_by_name(data, key, field);
  snprintf(key, sizeof key, "/%d/data/title", id);
  gwy_container_set_string_by_name(data, key, (const guchar*)g_strdup(title));
}

static void save(GwyContainer* data, const char* function, const char* name) {
  char path[4096];
  GError* error = NULL;
  snprintf(path, sizeof path, "%s/%s", folder, name);
  const gboolean whole = gwy_file_func_get_operations(function) & GWY_FILE_OPERATION_SAVE;
  gboolean (*run)(const gchar*, GwyContainer*, const gchar*, GwyRunType, GError**) =
      whole ? gwy_file_func_run_save : gwy_file_func_run_export;
  if (!run(function, data, path, GWY_RUN_NONINTERACTIVE, &error)) {
    fprintf(stderr, "%s: %s\n", name, error ? error->message : "not saved");
    exit(1);
  }
}

static void write_heights(void) {
  char path[4096];
  snprintf(path, sizeof path, "%s/heights.csv", folder);
  FILE* file = fopen(path, "w");
  for (int i = 0; i < rows * columns; ++i)
    fprintf(file, "%.17g%c", height_m(i / columns, i % columns),
            i % columns == columns - 1 ? '\n' : ',');
  fclose(file);
}

int main(int argc, char** argv) {
  gtk_init_check(&argc, &argv);
  if (argc != 2) return 2;
  folder = argv[1];
  gwy_app_init_nongui(NULL);
  gwy_app_data_browser_set_gui_enabled(FALSE);

  GwyContainer* one = gwy_container_new();
  add_channel(one, 0, "Topography", field(1, "m"));
  gwy_app_data_browser_add(one);
  gwy_app_data_browser_select_data_field(one, 0);
  GwyContainer* settings = gwy_app_settings_get();
  gwy_container_set_boolean_by_name(settings, "/module/asciiexport/add-comment", TRUE);
  gwy_container_set_int32_by_name(settings, "/module/asciiexport/precision", 16);
  save(one, "gsffile", "gwyddion.gsf");
  save(one, "asciiexport", "gwyddion_matrix.txt");
  save(one, "sdfile-txt", "gwyddion_text.sdf");
  save(one, "xyzexport", "gwyddion_points.xyz");
  save(one, "igorfile", "gwyddion.ibw");
  gwy_container_set_enum_by_name(settings, "/module/pixmap/mode", 1);
  save(one, "pngcairo", "gwyddion_16bit.png");

  GwyContainer* several = gwy_container_new();
  add_channel(several, 0, "Topography", field(1, "m"));
  add_channel(several, 2, "Amplitude", field(1e6, "V"));
  GwyDataField* mask = gwy_data_field_new(columns, rows, 0.7e-6 / 3, 1.1e-6, TRUE);
  gwy_data_field_get_data(mask)[columns * 2 + 3] = 1;
  gwy_data_field_get_data(mask)[columns * 4 + 6] = 1;
  gwy_container_set_object_by_name(several, "/0/mask", mask);
  save(several, "gwyfile", "gwyddion_mask.gwy");
  gwy_container_remove_by_name(several, "/0/mask");
  add_channel(several, 5, "Topography back", field(-2, "m"));
  save(several, "gwyfile", "gwyddion_channels.gwy");

  write_heights();
  return 0;
}
