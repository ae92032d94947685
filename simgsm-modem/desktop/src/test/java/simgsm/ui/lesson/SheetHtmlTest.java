package simgsm.ui.lesson;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Font;
import org.junit.jupiter.api.Test;
import simgsm.ui.glossary.GlossaryText;

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

    @Test
    void aSheetKeepsTablesAndStarsInCode() {
        String html = SheetHtml.of(
                "# A <b>\n\n**Time** 5 of *x*, [a link](b.md)\n\n| `a` | c |\n|---|---|\n| `**#*0` | **d** |\n",
                "#ffffff",
                "#1b1f24",
                GlossaryText.font(false));
        assertTrue(html.contains("color:#1b1f24"), html);
        assertTrue(html.contains("<h1>A &lt;b></h1>"), html);
        assertTrue(html.contains("<p><b>Time</b> 5 of <i>x</i>, a link</p>"), html);
        assertTrue(html.contains("<tt>**#*0</tt></td><td valign='top'><b>d</b>"), html);
    }

    @Test
    void anOrderAtTheBeginningOfALineIsNoHeading() {
        String html =
                SheetHtml.of("Then press\n#**20 and\n#*0\n\n## Next\n", "#ffffff", "#1b1f24", GlossaryText.font(false));
        assertTrue(html.contains("<p>Then press #**20 and #*0</p><h2>Next</h2>"), html);
    }
}
