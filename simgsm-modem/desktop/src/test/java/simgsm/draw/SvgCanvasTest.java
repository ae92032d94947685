package simgsm.draw;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Drawings as SVG. */
class SvgCanvasTest {
    private final SvgCanvas canvas = new SvgCanvas(ink -> ink.hex(Appearance.LIGHT));

    @Test
    void shapesAreWrittenInTheirGroupsWithInkAndPen() {
        canvas.moved(10, 20, Math.PI / 2, () -> {
            canvas.ink(Ink.DANGER, 0.5);
            canvas.pen(3);
            canvas.line(0, 0, 2, 1);
        });
        canvas.clipped(Outline.box(0, 0, 5, 5), () -> canvas.fill(Outline.box(0, 0, 1, 1)));
        canvas.group("robot", () -> canvas.pen(1, 4));
        canvas.draw(Outline.polygon(0, 0, 1.125, 1, 2, 0));
        String svg = canvas.elements();
        assertTrue(
                svg.contains("<g transform=\"translate(10,20) rotate(90)\">\n<path d=\"M0 0L2 1\" fill=\"none\""), svg);
        assertTrue(
                svg.contains("stroke=\"#b3261e\" stroke-opacity=\"0.5\" stroke-width=\"3\" stroke-linecap=\"round\""),
                svg);
        assertTrue(
                svg.contains("<clipPath id=\"clip1\"><path d=\"M0 0L5 0L5 5L0 5Z\"/></clipPath>\n<g clip-path="), svg);
        assertTrue(
                svg.contains("<g class=\"robot\">\n</g>\n<path d=\"M0 0L1.12 1L2 0Z\" fill=\"none\" stroke=\"#1b1f24\""
                        + " stroke-width=\"1\""),
                svg);
    }

    @Test
    void dashesHaveNoRoundEnds() {
        canvas.pen(1.4, 6);
        canvas.line(0, 0, 1, 1);
        assertTrue(canvas.elements().contains("stroke-width=\"1.4\" stroke-dasharray=\"6\""), canvas.elements());
    }

    @Test
    void textsAreCentredAndEscaped() {
        canvas.text("a & b", Face.MONO_STRONG, 5, 10);
        String svg = canvas.document(100, 50, "<t>");
        assertTrue(
                svg.contains("text-anchor=\"middle\" font-family=\"monospace\" font-size=\"13\" font-weight=\"bold\""),
                svg);
        assertTrue(svg.contains(">a &amp; b</text>"), svg);
        assertTrue(svg.contains("<title>&lt;t&gt;</title>"), svg);
        assertTrue(svg.contains("width=\"100\" height=\"50\" viewBox=\"0 0 100 50\""), svg);
    }

    @Test
    void barsLieOnWholePixels() {
        canvas.bar(1.3, 2.6, 10, 0.4);
        assertTrue(canvas.elements().contains("M1 3L11 3L11 4L1 4Z"), canvas.elements());
    }

    @Test
    void numbersAreShortAndNeverInALocale() {
        assertEquals("0", SvgCanvas.number(-0.001));
        assertEquals("1.5", SvgCanvas.number(1.5));
        assertEquals("100", SvgCanvas.number(100));
        assertEquals("0.01", SvgCanvas.number(0.0149));
    }

    @Test
    void outlinesAreReadAndPlaced() {
        assertEquals(
                "M1 2L3 4C5 6 7 8 9 10Z",
                Outline.parse("M1 2L3 4C5 6 7 8 9 10Z").toString());
        assertEquals(
                "M11 20L13 22", Outline.parse("M.5 0L1.5 1").placed(10, 20, 2).toString());
        assertEquals(Outline.circle(1, 2, 3).toString(), Outline.parse("O1 2 3").toString());
        assertEquals("M2 1C2 0.45 1.55 0 1 0", Outline.parse("A0 0 2 2 0 90").toString());
    }
}
