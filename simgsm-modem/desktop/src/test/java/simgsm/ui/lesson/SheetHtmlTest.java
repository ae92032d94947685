package simgsm.ui.lesson;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Font;
import org.junit.jupiter.api.Test;

class SheetHtmlTest {
    private static String html(String markdown) {
        return SheetHtml.of(markdown, "#ddeeff", "#000000", new Font(Font.DIALOG, Font.PLAIN, 13));
    }

    @Test
    void theFirstRowOfEachTableIsItsHeading() {
        String html =
                html("| step | green when |\n|---|---|\n| `a` | b |\n\n| question | answer |\n|---|---|\n| c | d |");
        assertTrue(
                html.contains("<th align='left' valign='top'>step</th><th align='left' valign='top'>green when</th>"),
                html);
        assertTrue(html.contains("<td valign='top'><tt>a</tt></td><td valign='top'>b</td>"), html);
        assertTrue(html.contains("<th align='left' valign='top'>question</th>"), html);
        assertEquals(2, html.split("<table").length - 1, html);
    }

    @Test
    void aHeadingBeginsWithUpToSixNumberSignsAndABlank() {
        String html = html("# Title\n#**20** is an order\n## Part");
        assertTrue(html.contains("<h1>Title</h1><p>#**20** is an order</p><h2>Part</h2>"), html);
    }

    @Test
    void aLinkToTheOtherSheetsIsLeftOut() {
        String html = html("`java -jar x.jar` \u00b7 [all lessons](README.md)\n\nSee [Console](../CONSOLE.md).");
        assertTrue(html.contains("<p><tt>java -jar x.jar</tt></p>"), html);
        assertTrue(html.contains("<p>See Console.</p>"), html);
        assertFalse(html.contains("all lessons"), html);
    }
}
