package simrobot.ui.floor;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.w3c.dom.Document;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.ui.Theme;
import simrobot.simulation.Simulation;
import simrobot.simulation.SimulationSnapshot;
import simrobot.ui.panel.WindowBench;
import simrobot.world.Segment;
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
                > office.world().items(Segment.class).size());
        assertEquals(
                "office.map", document.getElementsByTagName("title").item(0).getTextContent());
        String texts = "";
        for (int i = 0; i < document.getElementsByTagName("text").getLength(); i++) {
            texts += document.getElementsByTagName("text").item(i).getTextContent() + "\n";
        }
        assertTrue(texts.contains("anna\n") && texts.contains("<b>\n"), texts);
        assertTrue(texts.contains(" m\n"), texts);
    }

    @ParameterizedTest
    @ValueSource(strings = {"png", "svg"})
    void aPictureIsTheSameAtEveryZoomOfTheWindow(String ending) throws Exception {
        SimulationSnapshot scene = office().snapshot();
        byte[] normal = new WorldPictures().of(scene, "anna", ending);
        try {
            Theme.zoomTo(2);
            assertArrayEquals(normal, new WorldPictures().of(scene, "anna", ending));
        } finally {
            Theme.zoomTo(1);
        }
    }

    @Test
    void aPictureHasTheWindowsAppearance() throws Exception {
        SimulationSnapshot scene = office().snapshot();
        Theme.install(Appearance.DARK);
        String svg = new String(new WorldPictures().of(scene, "anna", "svg"), UTF_8);
        assertTrue(svg.contains(Ink.FLOOR.hex(Appearance.DARK)));
        assertFalse(svg.contains(Ink.FLOOR.hex(Appearance.LIGHT)));
    }
}
