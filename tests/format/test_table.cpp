#include <cmath>

#include "format/table.hpp"
#include "message_of.hpp"
#include "scratch.hpp"

using namespace fabricsh;
using namespace fabricsh::format;

namespace {

void check_pull(const std::string& text, char separator, char decimal) {
  INFO(text);
  const Table table = parse_table("pull.csv", text);
  REQUIRE(table.columns.size() == 2);
  CHECK(table.form.separator == separator);
  CHECK(table.form.decimal == decimal);
  CHECK(table.columns[0].values == std::vector<double>{0, 0.5, 1.25});
  CHECK(table.columns[1].values == std::vector<double>{0, -1.5, 2e-3});
}

std::string trouble(const std::string& text) {
  return message_of([&] { parse_table("pull.csv", text); });
}

}  // namespace

TEST_CASE("a table in every dialect reads the same", "[files]") {
  check_pull("0,0\n0.5,-1.5\n1.25,2e-3\n", ',', '.');
  check_pull("0;0\n0,5;-1,5\n1,25;2e-3\n", ';', ',');
  check_pull("0\t0\n0,5\t-1,5\n1,25\t0,002", '\t', ',');
  check_pull("  0   0\n 0.5  -1.5\n\n1.25  +2e-3\r\n", ' ', '.');
  check_pull("0 0\n0,5 -1,5\n1,25 0,002\n", ' ', ',');
  check_pull("\xEF\xBB\xBF\"u\",\"P\"\r\n\"0\",0\r\n0.5,-1.5\r\n# half way\r\n1.25,2e-3\r\n", ',', '.');
  check_pull("0,0,\n0.5,-1.5,\n1.25,2e-3,\n", ',', '.');
}

TEST_CASE("names and units come from the heading or the line below it", "[files]") {
  const Table one = parse_table("a", "% made by hand\nExtension (mm), Load [kN], Time / s\n1, 2, 3\n");
  CHECK(one.header);
  CHECK(one.columns[0].name == "Extension");
  CHECK(one.columns[0].unit == "mm");
  CHECK(one.columns[1].unit == "kN");
  CHECK(one.columns[2].name == "Time");
  CHECK(one.columns[2].unit == "s");
  const Table two = parse_table("b", "Test;7\nOperator;A. B.\nWeg;Kraft\n(mm);N\n0,1;2\n0,2;3\n");
  CHECK(two.columns[0].name == "Weg");
  CHECK(two.columns[0].unit == "mm");
  CHECK(two.columns[1].unit == "N");
  CHECK(two.preamble.size() == 4);
  const Table none = parse_table("c", "1 2\n3 4\n");
  CHECK_FALSE(none.header);
  CHECK(none.columns[1].name == "2");
}

TEST_CASE("a wrong table names file, line, column and what was expected", "[files]") {
  CHECK(trouble("u,P\n0,0\n1,2\n2,3\n3,4\n4,x\n") ==
        "pull.csv:6: column 'P': expected a finite number, got 'x'");
  CHECK(trouble("u,P\n0,0\n1,2\n2,3\n3,4\n4\n") == "pull.csv:6: expected 2 cells, got 1");
  CHECK(trouble("u,P\n0,0\n1,2\n2,3\n3,4\n4,nan\n") ==
        "pull.csv:6: column 'P': expected a finite number, got 'nan'");
  CHECK(trouble("0;0\n0,5;1\n1;2\n2;3\n3;4.5\n") ==
        "pull.csv:5: column '2': expected a finite number with a decimal comma, got '4.5'");
  CHECK(trouble("u,P\n0,0\n1,x\n2,3\n3,4\n4,5\n") ==
        "pull.csv:3: column 'P': expected a finite number, got 'x'");
  CHECK(trouble("u,P\n0,x\n2,3\n3,4\n4,5\n") == "pull.csv:2: column 'P': expected a finite number, got 'x'");
  CHECK(trouble("only words\n").starts_with("pull.csv:1: expected lines of numbers"));
  CHECK(message_of([] { read_table("/no/such.csv"); }).find("/no/such.csv") != std::string::npos);
}

TEST_CASE("the decimal sign is settled by all rows", "[files]") {
  const Table t = parse_table("a", "0;0\n1;1\n2;2\n3;3\n4;0,5\n5;1\n");
  CHECK(t.form.decimal == ',');
  CHECK(t.columns[1].values == std::vector<double>{0, 1, 2, 3, 0.5, 1});
  CHECK(trouble("0;0\n1;1\n2;2\n3;3\n4;0.5\n5;x\n") ==
        "pull.csv:6: column '2': expected a finite number, got 'x'");
  CHECK(parse_table("b", "0 0\n1 1\n2 2\n3 3\n4 -0,5\n").columns[1].values[4] == -0.5);
}

TEST_CASE("columns of text and rows without a number", "[files]") {
  const Table t = parse_table("a",
                              "Operator;A. B.\nDate;Cycle;u;P\n12:00:01;1-Load;0;0,5\n12:00:02;1-Load;1;2\n"
                              "12:00:03;2-Load;2;3\n12:00:04;2-Load;3;4\n");
  REQUIRE(t.columns.size() == 4);
  CHECK(t.columns[0].name == "Date");
  CHECK(t.columns[0].text);
  CHECK(t.columns[1].error ==
        "a:3: column 'Cycle': expected a finite number with a decimal comma, got '1-Load'");
  CHECK(t.columns[3].values == std::vector<double>{0.5, 2, 3, 4});
  CHECK(trouble("u,P\nNaN,NaN\n0,0\n1,2\n2,3\n3,4\n") ==
        "pull.csv:2: column 'u': expected a finite number, got 'NaN'");
  const Table gap = parse_table("b", "t,u,P\n0,0,\n1,1,2\n2,2,3\n3,3,4\n4,4,5\n", {0, 0, true});
  CHECK(gap.columns[1].values.size() == 5);
  CHECK(std::isnan(gap.columns[2].values[0]));
  CHECK(gap.columns[2].error == "b:2: column 'P': expected a finite number, got ''");
  CHECK(gap.columns[1].error.empty());
  const Table often = parse_table("c", "t,u,P\n0,0,\n1,1,2\n2,2,\n3,3,4\n4,4,\n", {0, 0, true});
  CHECK(often.columns[2].values[3] == 4);
  CHECK(often.columns[1].values[4] == 4);
  // lines that describe a specimen are no rows
  CHECK(parse_table("d", "Length;100\nWidth;25\nSpeed;5\nArea;3\nu;P\n0;0\n1;2\n").columns[0].values.size() ==
        2);
}

TEST_CASE("words under the last row are no rows", "[files]") {
  const Table t = parse_table("a",
                              "u\tP\nmm\tN\n0\t0\n1\t2\n2\t4\n3\t6\n4\t8\n5\t10\n6\t12\n7\t14\n8\t16\n\n"
                              "Data Header: Timer: 15 Sec\nEnd of test\n");
  CHECK(t.columns[1].values == std::vector<double>{0, 2, 4, 6, 8, 10, 12, 14, 16});
  CHECK(trouble("u,P\n0,0\n1,1\n2,2\n3,3\n4\n").ends_with(":6: expected 2 cells, got 1"));
  CHECK(trouble("u,P\n0,0\n1,1\n2,2\n3,3\nend\n4,4\n").ends_with(":6: expected 2 cells, got 1"));
  // a row of totals is one too, and told; rows that share their word belong to a specimen of that name
  const Table totals = parse_table("b", "u,P\n0,0\n1,1\n2,2\n3,3\nMean,1,2\nMaximum,3\n");
  CHECK(totals.columns[0].values == std::vector<double>{0, 1, 2, 3});
  REQUIRE(totals.left_out.size() == 2);
  CHECK(totals.left_out[1].line == 7);
  CHECK(totals.left_out[1].text == "Maximum,3");
  CHECK(trouble("k,u\n1,0\n1,1\n2,0\n2,1\nA,0\nA,1\n")
            .ends_with(":6: column 'k': expected a finite number, got 'A'"));
}

TEST_CASE("a file holds as many tables as it has headings", "[files]") {
  const std::string text =
      "Run 1\nu (mm);P (N)\n0;0\n1;2,5\n2;4\n\nRun 2\nLength;25\nu (mm);P "
      "(kN);t\n0;0;1\n1;0,5;2\n2;1;3\n3;2;4\n";
  const auto tables = parse_tables("a", text);
  REQUIRE(tables.size() == 2);
  CHECK(tables[0].columns[1].values == std::vector<double>{0, 2.5, 4});
  CHECK(tables[1].columns.size() == 3);
  CHECK(tables[1].columns[1].unit == "kN");
  CHECK(tables[1].columns[1].values == std::vector<double>{0, 0.5, 1, 2});
  CHECK(tables[1].preamble == std::vector<std::string>{"Run 2", "Length;25", "u (mm);P (kN);t"});
  CHECK(tables[1].lines == std::vector<std::size_t>{10, 11, 12, 13});
  CHECK(trouble(text).ends_with(
      "a further table begins here, table 2 of 2: expected one table; blocks=true reads each"));
  // equal headings over columns that go on are one table
  const Table one = parse_table("b", "t,u\n0,0\n1,2\n2,4\nt,u\n3,6\nt,u\n4,8\n");
  CHECK(one.columns[1].values == std::vector<double>{0, 2, 4, 6, 8});
  CHECK(parse_tables("c", "t,u\n0,0\n1,2\n2,4\nt,u\n0,6\n1,7\n").size() == 2);
  // words that repeat are no heading
  CHECK(trouble("t,u\n0,0\n1,2\nover,over\n3,4\n")
            .ends_with(":4: column 't': expected a finite number, got 'over'"));
}

TEST_CASE("the whole file decides what stands between cells", "[files]") {
  CHECK(trouble("u,P\n0,0\n1\n2,4\n3,6\n4,8\n5,10\n").ends_with(":3: expected 2 cells, got 1"));
  CHECK(parse_table("a", "P\n0\n0,5\n1\n1,5\n").columns[0].values == std::vector<double>{0, 0.5, 1, 1.5});
}

TEST_CASE("typographic signs, and thousands that the deck names", "[files]") {
  const Table t = parse_table("a", "%;N\n\u22120,5;1\u202f234,5\n1;-2\u00a0000\n2;3\u2019000,25\n");
  CHECK(t.columns[0].name == "%");
  CHECK(t.columns[0].values == std::vector<double>{-0.5, 1, 2});
  CHECK(t.columns[1].values == std::vector<double>{1234.5, -2000, 3000.25});
  CHECK(trouble("0,5;1\n0,5;1\n0,5;1\n0,5;1\n1;1.234\n")
            .ends_with("got '1.234'; if its point stands between thousands, give thousands='.'"));
  CHECK(parse_table("b", "0,5;1,5\n1;1.234\n", {0, 0, false, '.'}).columns[1].values ==
        std::vector<double>{1.5, 1234});
  CHECK(trouble("0;1\n0;1\n0;1\n0;1\n1;12 34\n").ends_with("got '12 34'"));
  CHECK(trouble("0;1\n0;1\n0;1\n0;1\n1;1 234 56\n").ends_with("got '1 234 56'"));
}

TEST_CASE("an empty last column and units with gaps keep their headings", "[files]") {
  const Table t = parse_table("a", "k,u,error\n1,2,\n2,3,\n");
  REQUIRE(t.columns.size() == 3);
  CHECK(t.columns[2].name == "error");
  CHECK(t.columns[1].values == std::vector<double>{2, 3});
  const Table filled = parse_table("b", "k,u,error\n1,2,\n2,3,\n3,4,\n4,5,\n5,6,broken\n");
  CHECK(filled.columns[2].words == std::vector<std::string>{"", "", "", "", "broken"});
  const Table gaps =
      parse_table("c", "Data:\tNo.\tTime\tForce\tStatus\n\t\t[s]\t[N]\n\t1\t0\t2\t\n\t2\t1\t3\t\n");
  REQUIRE(gaps.columns.size() == 5);
  CHECK(gaps.columns[2].unit == "s");
  CHECK(gaps.columns[3].unit == "N");
  CHECK(gaps.columns[4].name == "Status");
}

TEST_CASE("lines of separators alone are no rows, and hide no heading", "[files]") {
  const Table t = parse_table("a", ";No.;t;P\n;;;\n;;[s];[N]\n;1;0;2,5\n;;;\n;2;1;3,5\n;3;2;7\n;;;\n;;;\n");
  REQUIRE(t.columns.size() == 4);
  CHECK(t.columns[2].name == "t");
  CHECK(t.columns[3].unit == "N");
  CHECK(t.columns[3].values == std::vector<double>{2.5, 3.5, 7});
  CHECK(t.lines == std::vector<std::size_t>{4, 6, 7});
  CHECK(parse_table("b", "t;P\n0;2\n1;3\n2;4\nFmax;4,0 N\n").left_out.at(0).numbers);
}

TEST_CASE("thousands are read where they cannot be decimals", "[files]") {
  const auto second = [](const std::string& cell, char separator) {
    return parse_table("a", std::string("u") + separator + "P\n0.5" + separator + cell + "\n")
        .columns[1]
        .values[0];
  };
  CHECK(second("1,234.5", ';') == 1234.5);
  CHECK(second("\"-12,345,678.25\"", ',') == -12345678.25);
  CHECK(second("1,234,567", '\t') == 1234567);
  CHECK(parse_table("b", "0,5;1.234,5\n").columns[1].values[0] == 1234.5);
  CHECK(parse_table("c", "0;1,234\n").columns[1].values[0] == 1.234);
  CHECK(trouble("0.5;1\n0.5;1\n0.5;1\n0.5;1\n0.5;1,234\n")
            .ends_with("got '1,234'; if its comma stands between thousands, give thousands=','"));
  for (const std::string wrong : {"1,23.5", "1234,567.5", ",234.5", "1,2345.5", "1,,234.5"})
    CHECK(trouble("0.5;1\n0.5;1\n0.5;1\n0.5;1\n0.5;" + wrong + "\n").ends_with("got '" + wrong + "'"));
}

TEST_CASE("a text in quotes is one cell, commas and doubled quotes in it") {
  const Table t = parse_table("a",
                              "\"Extension, total (mm)\",\"Load \"\"raw, set\"\" (N)\",Note\n0,0.5,\"a, b\"\n"
                              "1,2,\"a, \"\"b\"\", c\"\n2,3,d\n3,4,e\n4,5,f\n");
  REQUIRE(t.columns.size() == 3);
  CHECK(t.columns[0].name == "Extension, total");
  CHECK(t.columns[0].unit == "mm");
  CHECK(t.columns[1].name == "Load \"raw, set\"");
  CHECK(t.columns[1].values == std::vector<double>{0.5, 2, 3, 4, 5});
  CHECK(t.columns[2].text);
}

TEST_CASE("decimal commas in quotes between commas", "[files]") {
  const Table t = parse_table("a", "u,P\n\"0,0\",\"0,5\"\n1,\"2,5\"\n\"1,5\",\"1,500\"\n");
  CHECK(t.form.decimal == ',');
  CHECK(t.columns[0].values == std::vector<double>{0, 1, 1.5});
  CHECK(t.columns[1].values == std::vector<double>{0.5, 2.5, 1.5});
  // also if the first rows do not tell
  const Table late = parse_table("b", "u,P\n0,0\n1,1\n2,2\n3,3\n4,\"4,5\"\n");
  CHECK(late.columns[1].values == std::vector<double>{0, 1, 2, 3, 4.5});
  CHECK(parse_table("c", "u,P\n0,\"1,000\"\n1,\"2,000\"\n", {0, ','}).columns[1].values ==
        std::vector<double>{1, 2});
  for (const char* rows : {"0,\"1,000\"\n1,\"2,000\"\n", "0,1\n1,1\n2,2\n3,3\n4,\"1,000\"\n"})
    CHECK(trouble(std::string("u,P\n") + rows)
              .ends_with(
                  "column 'P': expected a finite number, got '1,000': its comma may be a decimal sign or "
                  "stand between thousands; give decimal=',', or write such numbers without it"));
  // a column that nobody needs does not spoil the others
  const Table other = parse_table("d", "u,P,n\n0,0.5,\"1,000\"\n1,1.5,\"2,000\"\n", {0, 0, true});
  CHECK(other.columns[1].values == std::vector<double>{0.5, 1.5});
  CHECK_FALSE(other.columns[2].error.empty());
}

TEST_CASE("a first row with too many or too few cells is not taken for text above the table", "[files]") {
  CHECK(trouble("note,u,P\nx \"a, b\",0,0\ny,1,2\ny,2,4\n") == "pull.csv:2: expected 3 cells, got 4");
  CHECK(trouble("t,u,P\n0,0\n1,2,3\n2,4,5\n") == "pull.csv:2: expected 3 cells, got 2");
}

namespace {

std::string utf16(const std::string& text, bool high_first) {
  std::string out = high_first ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : text) out += high_first ? std::string{'\0', c} : std::string{c, '\0'};
  return out;
}

}  // namespace

TEST_CASE("UTF-16 and lines that end with carriage returns are read") {
  const std::string text = "Weg (mm);Kraft (N)\r\n0;0,5\r\n1;2,5\r\n";
  const std::vector<std::string> forms = {utf16(text, false), utf16(text, true),
                                          "Weg (mm);Kraft (N)\r0;0,5\r1;2,5\r"};
  for (const std::string& bytes : forms) {
    const Table t = parse_table("a", bytes);
    CHECK(t.columns[0].name == "Weg");
    CHECK(t.columns[1].values == std::vector<double>{0.5, 2.5});
  }
  // letters beyond ASCII, and beyond 16 bits: e with acute, the sign for per mille, a clef
  const std::string other(
      "\xFF\xFE\xE9\0\x30\x20\x34\xD8\x1E\xDD;\0P\0\n\0"
      "1\0;\0"
      "2\0\n\0",
      24);
  CHECK(parse_table("b", other).columns[0].name == "\u00e9\u2030\U0001d11e");
}

TEST_CASE("files that are no text say what they are") {
  CHECK(trouble("") == "pull.csv:1: expected plain text, got an empty file");
  CHECK(trouble("\r\n \n") == "pull.csv:1: expected plain text, got an empty file");
  CHECK(trouble("PK\x03\x04rest") ==
        "pull.csv:1: expected plain text, got a spreadsheet (.xlsx, .ods) or another archive; save the sheet "
        "as CSV");
  CHECK(trouble("\xD0\xCF\x11\xE0rest") ==
        "pull.csv:1: expected plain text, got a spreadsheet (.xls); save the sheet as CSV");
  CHECK(
      trouble(utf16("0;1\n", false).substr(2)) ==
      "pull.csv:1: expected plain text, got bytes of value zero: a binary file, or UTF-16 without its mark; "
      "save it as text, UTF-8");
}

TEST_CASE("a million rows are read", "[files]") {
  const ScratchFolder folder;
  {
    std::ofstream file(folder / "long.csv");
    file << "time (s),displacement (mm),force (N)\n";
    for (int i = 0; i < 1000000; ++i) file << i * 0.001 << ',' << i * 1.25e-5 << ',' << i * 3.1e-4 << '\n';
  }
  const Table table = read_table(folder / "long.csv");
  for (const auto& column : table.columns) CHECK(column.values.size() == 1000000);
  CHECK(table.columns[2].values.back() == Approx(999999 * 3.1e-4).epsilon(1e-5));  // six digits were written
}

TEST_CASE("a line too long for a table is refused before it is split") {
  const std::string rows = "a,b\n1,2\n3,4\n";
  CHECK(parse_table("long.csv", rows + std::string(16 << 20, ' ') + "\n5,6\n").columns[0].values.size() == 3);
  says(message_of([&] { parse_table("long.csv", rows + std::string((16 << 20) + 1, '1') + "\n5,6\n"); }),
       "long.csv:4: expected a line of at most 16777216 bytes, got one of 16777217");
  says(message_of([&] { parse_table("long.csv", std::string(20 << 20, ',')); }),
       "long.csv:1: expected a line of at most 16777216 bytes, got one of 20971520");
}

TEST_CASE(
    "a quoted number of a nought, a comma and three digits has a decimal comma: thousands begin with no "
    "nought",
    "[files]") {
  // Alone it settles the others of its file, which might be thousands.
  const Table t = parse_table("a", "u,P\n1,\"1,500\"\n2,\"0,123\"\n3,\"-0,456\"\n4,\"12,345\"\n");
  CHECK(t.form.decimal == ',');
  CHECK(t.columns[1].values == std::vector<double>{1.5, 0.123, -0.456, 12.345});
  CHECK(t.columns[0].values == std::vector<double>{1, 2, 3, 4});
  // Nor do numbers of two or four digits behind the comma stand for thousands.
  CHECK(parse_table("b", "u,P\n1,\"1,50\"\n2,\"1,234\"\n").columns[1].values ==
        std::vector<double>{1.5, 1.234});
  CHECK(parse_table("c", "u,P\n1,\"1,5000\"\n2,\"1,234\"\n").columns[1].values ==
        std::vector<double>{1.5, 1.234});
  // 10,123 may be ten thousand.
  says(trouble("u,P\n1,\"10,123\"\n2,\"20,456\"\n"),
       "its comma may be a decimal sign or stand between thousands");
}
