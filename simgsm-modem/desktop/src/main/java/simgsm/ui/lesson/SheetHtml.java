package simgsm.ui.lesson;

import java.awt.Font;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A teacher's sheet as HTML: Markdown headings, paragraphs, lists, tables, bold and code; links become their texts.
 */
final class SheetHtml {
    private final StringBuilder html = new StringBuilder();
    private final List<String> paragraph = new ArrayList<>();
    private final String headColor;
    private boolean isTable;

    private SheetHtml(String headColor) {
        this.headColor = headColor;
    }

    /**
     * @param headColor background of the first row of tables, as {@code #rrggbb}
     * @param textColor likewise
     */
    static String of(String markdown, String headColor, String textColor, Font font) {
        SheetHtml sheet = new SheetHtml(headColor);
        sheet.html
                .append("<html><body style='margin:0; color:" + textColor + "; font-family:" + font.getFamily())
                .append("; font-size:" + font.getSize() + "pt'>");
        markdown.lines().forEach(sheet::line);
        sheet.end();
        return sheet.html.append("</body></html>").toString();
    }

    private void line(String line) {
        if (line.startsWith("|")) {
            row(line);
        } else if (line.matches("#{1,6} .*")) {
            end();
            int level = line.indexOf(' ');
            html.append("<h").append(level).append('>').append(inline(line.substring(level + 1)));
            html.append("</h").append(level).append('>');
        } else if (line.startsWith("- ")) {
            end();
            html.append("<p>\u2022 ").append(inline(line.substring(2))).append("</p>");
        } else if (line.isBlank()) {
            end();
        } else {
            endTable();
            paragraph.add(line.strip());
        }
    }

    private void row(String line) {
        if (line.matches("[|: -]+")) {
            return;
        }
        boolean isHead = !isTable;
        if (isHead) {
            end();
            html.append("<table border='1' cellspacing='0' cellpadding='4' width='100%' style='margin-top:8px'>");
            isTable = true;
        }
        html.append(isHead ? "<tr bgcolor='" + headColor + "'>" : "<tr>");
        String cellTag = isHead ? "th align='left'" : "td";
        Arrays.stream(line.substring(1).split("(?<!\\\\)\\|"))
                .forEach(cell -> html.append("<" + cellTag + " valign='top'>")
                        .append(inline(cell.strip().replace("\\|", "|")))
                        .append(isHead ? "</th>" : "</td>"));
        html.append("</tr>");
    }

    private void end() {
        endTable();
        if (!paragraph.isEmpty()) {
            html.append("<p>").append(inline(String.join(" ", paragraph))).append("</p>");
            paragraph.clear();
        }
    }

    private void endTable() {
        if (isTable) {
            html.append("</table>");
            isTable = false;
        }
    }

    private static String inline(String text) {
        StringBuilder out = new StringBuilder();
        // Stars in code are kept.
        String[] parts = text.split("`", -1);
        for (int i = 0; i < parts.length; i++) {
            String escaped = parts[i].replace("&", "&amp;").replace("<", "&lt;");
            if (i % 2 == 1) {
                out.append("<tt>").append(escaped).append("</tt>");
            } else {
                // Removes the link to the list of all sheets, which the window does not have.
                out.append(escaped.replaceAll(" \u00b7 \\[[^]]*]\\(README[.]md\\)", "")
                        .replaceAll("\\[([^]]*)]\\([^)]*\\)", "$1")
                        .replaceAll("\\*\\*([\\p{L}][^*]*)\\*\\*", "<b>$1</b>")
                        .replaceAll("(?<![*\\p{L}])\\*([\\p{L}¿][^*]*)\\*(?![*\\p{L}])", "<i>$1</i>"));
            }
        }
        return out.toString();
    }
}
