package simrobot.ui.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Document;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.ui.Theme;
import simrobot.simulation.Simulation;
import simrobot.ui.panel.WindowBench;
import vericommand.Instruction;

/** The world as files: pixels and lines of the same painters. */
class WorldPicturesTest {
    @BeforeEach
    void light() {
        Theme.install(Appearance.LIGHT);
    }

    private static Simulation office() throws Exception {
        Simulation simulation = new Simulation(WindowBench.world("office.map"), 1);
        simulation.addRobot("anna").start(new Instruction.Forward(100), ended -> {});
        simulation.addRobot("<b>");
        simulation.run(300);
        return simulation;
    }

    @Test
    void aPngShowsWallsAndRobots() throws Exception {
        byte[] png = new WorldPictures().of(office().snapshot(), "anna", "png");
        BufferedImage image = ImageIO.read(new ByteArrayInputStream(png));
        assertEquals(2400, image.getWidth());
        assertTrue(WindowBench.count(image, Ink.WALL) > 1000);
        assertTrue(WindowBench.count(image, Ink.ROBOT) > 100);
    }

    @Test
    void anSvgIsADocumentWithLinesNamesAndTheScale() throws Exception {
        Simulation office = office();
        byte[] svg = new WorldPictures().of(office.snapshot(), "anna", "svg");
        Document document =
                DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(new ByteArrayInputStream(svg));
        assertEquals("svg", document.getDocumentElement().getTagName());
        assertTrue(document.getElementsByTagName("path").getLength()
                > office.world().segments().size());
        assertEquals(
                "office.map", document.getElementsByTagName("title").item(0).getTextContent());
        String texts = "";
        for (int i = 0; i < document.getElementsByTagName("text").getLength(); i++) {
            texts += document.getElementsByTagName("text").item(i).getTextContent() + "\n";
        }
        assertTrue(texts.contains("anna\n") && texts.contains("<b>\n"), texts);
        assertTrue(texts.contains(" m\n"), texts);
    }

    @Test
    void theCanvasWritesShapesWhereTheyAreTransformedTo() {
        SvgCanvas canvas = new SvgCanvas(100, 50, "t");
        Graphics2D g = (Graphics2D) canvas.create();
        g.translate(10, 20);
        g.scale(2, 2);
        g.setColor(new Color(255, 0, 0, 128));
        g.setStroke(new BasicStroke(1.5f));
        g.draw(new Line2D.Double(0, 0, 1, 0.5));
        g.clip(new Rectangle2D.Double(0, 0, 5, 5));
        g.fill(new Rectangle2D.Double(0, 0, 1, 1));
        g.setFont(new Font(Font.MONOSPACED, Font.BOLD, 12));
        g.drawString("a & b", 0, 0);
        g.dispose();
        String svg = canvas.document();
        assertTrue(
                svg.contains("<path d=\"M10 20L12 21\" fill=\"none\" stroke=\"#ff0000\" stroke-opacity=\"0.5\""), svg);
        assertTrue(svg.contains("stroke-width=\"3\""), svg);
        assertTrue(svg.contains("<clipPath id=\"clip1\"><path d=\"M10 20"), svg);
        assertTrue(svg.contains("fill-opacity=\"0.5\" clip-path=\"url(#clip1)\"/>"), svg);
        assertTrue(svg.contains("font-family=\"monospace\" font-size=\"12\" font-weight=\"bold\""), svg);
        assertTrue(svg.contains(">a &amp; b</text>"), svg);
    }

    @Test
    void picturesAreRefused() {
        SvgCanvas canvas = new SvgCanvas(10, 10, "");
        BufferedImage image = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
        assertThrows(UnsupportedOperationException.class, () -> canvas.drawImage(image, 0, 0, null));
    }

    @Test
    void numbersAreShortAndNeverInALocale() {
        assertEquals("0", SvgText.number(-0.001));
        assertEquals("1.5", SvgText.number(1.5));
        assertEquals("100", SvgText.number(100));
        assertEquals("x&lt;y &#34;".replace("&#34;", "&quot;"), SvgText.escaped("x<y \""));
    }
}
