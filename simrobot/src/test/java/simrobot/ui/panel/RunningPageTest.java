package simrobot.ui.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Locale;
import javax.swing.AbstractButton;
import javax.swing.Action;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.draw.Appearance;
import simgsm.ui.ComponentNames;
import simgsm.ui.Lamp;
import simgsm.ui.Theme;
import simgsm.ui.pane.Divider;
import simrobot.ui.TextLine;
import simrobot.ui.floor.WorldView;
import vericommand.LocalizedText;
import vericommand.OrderCourse;
import vericommand.OrderSource;
import vericommand.VeriCommandSnapshot;

/** SimRobot's page in the sizes that the demo gives its window; the frame takes 4 by 28 pixels of them. */
class RunningPageTest {
    @BeforeEach
    void look() {
        Theme.install(Appearance.LIGHT);
    }

    @AfterEach
    void normalZoom() {
        Theme.zoomTo(1);
    }

    private static WindowBench bench(Locale language, int width, int height) throws Exception {
        WindowBench bench = new WindowBench("demo.map", language, "robot");
        bench.lines = List.of(WindowBench.line("robot", true, true, WindowBench.noOrders(), "163"));
        bench.show();
        for (int i = 0; i < 3; i++) {
            bench.resize(width, height);
        }
        return bench;
    }

    @ParameterizedTest(name = "{0} x {1} at {2} %: {3} x {4}")
    @CsvSource({
        "1024, 768, 85, 738, 492",
        "1280, 720, 100, 944, 432",
        "1366, 768, 100, 1030, 472",
        "1600, 1000, 110, 1230, 640",
        "1600, 1000, 130, 1163, 615",
        "1920, 1080, 100, 1584, 692",
        "1920, 1080, 120, 1516, 692",
        "1920, 1080, 150, 1416, 636",
        "2560, 1440, 160, 2022, 922",
        "3840, 2160, 200, 3168, 1383",
    })
    void theWorldTakesAFifthOfTheScreenAndTheScopeIsWhole(
            int screenWidth, int screenHeight, int percent, int width, int height) throws Exception {
        Theme.zoomTo(percent / 100.0);
        for (Locale language : List.of(Locale.ENGLISH, new Locale("es"))) {
            WindowBench bench = bench(language, width - 4, height - 28);
            Component world = bench.component("world");
            double share = (double) world.getWidth() * world.getHeight() / (screenWidth * screenHeight);
            assertTrue(share >= 0.2, "the world takes " + share);
            assertWhole(bench, "scope.picture", 280, 132);
            assertWhole(bench, "order.keys", 100, 34);
            assertWhole(bench, "replies", 120, 26);
        }
    }

    @ParameterizedTest
    @CsvSource({"100, 692, 584", "100, 744, 375", "100, 1030, 560", "120, 1516, 692", "150, 1416, 636", "100, 1100, 800"
    })
    void anOrderOfThreeLegsAndItsOutcomeAreBothReadable(int percent, int width, int height) throws Exception {
        Theme.zoomTo(percent / 100.0);
        for (Locale language : List.of(Locale.ENGLISH, new Locale("es"))) {
            for (OrderCourse course : List.of(OrderCourse.EXECUTED, OrderCourse.CALL_ENDED)) {
                WindowBench bench = new WindowBench("demo.map", language, "robot");
                VeriCommandSnapshot order = new VeriCommandSnapshot(
                        "5550100",
                        OrderSource.CALL,
                        true,
                        true,
                        "**#**100#*#90#**100**",
                        new LocalizedText(
                                "forward 100 cm, turn right 90 degrees, forward 100 cm",
                                "avanzar 100 cm, girar 90 grados a la derecha, avanzar 100 cm"),
                        "accepted",
                        WindowBench.said("accepted"),
                        course,
                        0,
                        List.of());
                bench.lines = List.of(WindowBench.line("robot", true, true, order, "163"));
                bench.show().resize(width, height).resize(width, height);
                Lamp verdict = (Lamp) bench.component("order.verdict");
                TextLine words = (TextLine) bench.component("order.words");
                Component outcome = bench.component("order.course");
                Component replies = bench.component("replies");
                assertTrue(verdict.getHeight() >= verdict.heightFor(verdict.getWidth()), "verdict in " + language);
                assertTrue(!words.isVisible() || words.getHeight() >= words.heightFor(words.getWidth()), "words");
                assertFalse(verdict.getBounds().intersects(outcome.getBounds()));
                assertFalse(outcome.getBounds().intersects(replies.getBounds()));
                assertFalse(bench.component("order.keys").getBounds().intersects(verdict.getBounds()));
                if (course == OrderCourse.EXECUTED && outcome.getHeight() == 0) {
                    assertWhole(bench, "reply.3", 40, 16);
                } else {
                    assertTrue(outcome.getWidth() >= outcome.getPreferredSize().width, course + " in " + language);
                    assertWhole(bench, "order.course", 40, 16);
                }
            }
        }
    }

    /** The component lies inside the panel and has at least this size in units. */
    private static void assertWhole(WindowBench bench, String name, int widthUnits, int heightUnits) {
        Component part = bench.component(name);
        assertTrue(isShown(part, bench.panel), name + " is hidden");
        assertTrue(part.getWidth() >= Theme.px(widthUnits) - 2, name + " is " + part.getWidth() + " wide");
        assertTrue(part.getHeight() >= Theme.px(heightUnits) - 2, name + " is " + part.getHeight() + " high");
        var corner = SwingUtilities.convertRectangle(part.getParent(), part.getBounds(), bench.panel);
        assertTrue(corner.getMaxX() <= bench.panel.getWidth() && corner.getMaxY() <= bench.panel.getHeight(), name);
        for (Component outer = part.getParent(); outer != bench.panel; outer = outer.getParent()) {
            assertTrue(outer.getWidth() >= part.getWidth() && outer.getHeight() >= part.getHeight(), name + " is cut");
        }
    }

    private static boolean isShown(Component part, Component root) {
        for (Component at = part; at != root; at = at.getParent()) {
            if (!at.isVisible()) {
                return false;
            }
        }
        return true;
    }

    @Test
    void theInspectorGivesWayFirstAndAKeyBringsItBack() throws Exception {
        WindowBench bench = bench(Locale.ENGLISH, 940, 400);
        Component pose = bench.component("pose.x");
        assertFalse(isShown(pose, bench.panel));
        ((AbstractButton) bench.component("tool.inspector")).doClick();
        bench.resize(940, 400).resize(940, 400);
        assertTrue(isShown(pose, bench.panel));
        assertFalse(isShown(bench.component("scope.picture"), bench.panel));
        ((AbstractButton) bench.component("tool.inspector")).doClick();
        bench.resize(940, 400).resize(940, 400);
        assertFalse(isShown(pose, bench.panel));
        assertTrue(isShown(bench.component("scope.picture"), bench.panel));
    }

    @Test
    void theKeyOfATabOpensTheHiddenInspector() throws Exception {
        WindowBench bench = bench(Locale.ENGLISH, 940, 400);
        press(bench, KeyStroke.getKeyStroke(KeyEvent.VK_2, InputEvent.ALT_DOWN_MASK));
        bench.resize(940, 400).resize(940, 400);
        assertTrue(isShown(bench.component("events"), bench.panel));
        press(bench, KeyStroke.getKeyStroke(KeyEvent.VK_2, InputEvent.ALT_DOWN_MASK));
        bench.resize(940, 400).resize(940, 400);
        assertTrue(isShown(bench.component("events"), bench.panel));
    }

    @Test
    void theKeyForANewRobotOpensTheHiddenInspector() throws Exception {
        WindowBench bench = bench(Locale.ENGLISH, 940, 400);
        assertFalse(isShown(bench.component("newcomer.name"), bench.panel));
        press(bench, KeyStroke.getKeyStroke(KeyEvent.VK_N, InputEvent.CTRL_DOWN_MASK));
        bench.resize(940, 400).resize(940, 400);
        assertTrue(isShown(bench.component("newcomer.name"), bench.panel));
    }

    @Test
    void aPresentationHasOnlyTheFloorAndOneLine() throws Exception {
        WindowBench bench = bench(Locale.ENGLISH, 1100, 800);
        VeriCommandSnapshot order = new VeriCommandSnapshot(
                "5550100",
                OrderSource.CALL,
                true,
                true,
                "**#**20**",
                WindowBench.said("forward 20 cm"),
                "accepted",
                WindowBench.said(""),
                OrderCourse.UNDER_WAY,
                0,
                List.of());
        // 3 has answered an earlier order of the call
        bench.lines = List.of(WindowBench.line("robot", true, true, order, "1636"));
        bench.show();
        press(bench);
        bench.resize(1100, 800).resize(1100, 800);
        Component world = bench.component("world");
        assertTrue((double) world.getWidth() * world.getHeight() >= 0.8 * 1100 * 800);
        assertFalse(isShown(bench.component("tool.power"), bench.panel));
        assertFalse(isShown(bench.component("scope.picture"), bench.panel));
        assertTrue(
                bench.spoken("presentation").endsWith("forward 20 cm  \u2013  6 executing"),
                bench.spoken("presentation"));
        press(bench);
        bench.resize(1100, 800).resize(1100, 800);
        assertTrue(isShown(bench.component("tool.power"), bench.panel));
        assertEquals(false, isShown(bench.component("presentation"), bench.panel));
    }

    @Test
    void theStateOfTheRobotIsShownOnTheMostUsualScreen() throws Exception {
        Theme.zoomTo(1.2);
        for (Locale language : List.of(Locale.ENGLISH, new Locale("es"))) {
            WindowBench bench = bench(language, 1512, 664);
            assertTrue(isShown(bench.component("status.stopped"), bench.panel));
            assertTrue(isShown(bench.component("scope.picture"), bench.panel));
        }
    }

    @Test
    void escapeEndsAPresentationAfterItHasHiddenTheRuler() throws Exception {
        KeyStroke escape = KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0);
        WindowBench bench = bench(Locale.ENGLISH, 1100, 800);
        press(bench, escape);
        assertFalse(isShown(bench.component("presentation"), bench.panel));
        press(bench);
        WorldView world = (WorldView) bench.component("world");
        Action inTheFloor = world.getActionMap()
                .get(world.getInputMap(JComponent.WHEN_FOCUSED).get(escape));
        world.toggleRuler();
        assertTrue(inTheFloor.isEnabled());
        inTheFloor.actionPerformed(new ActionEvent(world, 0, ""));
        assertNull(world.ruler());
        // Swing passes a key on to the window where its action is disabled
        assertFalse(inTheFloor.isEnabled());
        press(bench, escape);
        bench.resize(1100, 800);
        assertTrue(isShown(bench.component("tool.power"), bench.panel));
        assertFalse(isShown(bench.component("presentation"), bench.panel));
    }

    @Test
    void theKeysOfTheToolsWorkInAPresentation() throws Exception {
        WindowBench bench = bench(Locale.ENGLISH, 1100, 800);
        press(bench);
        bench.resize(1100, 800).resize(1100, 800);
        press(bench, KeyStroke.getKeyStroke(KeyEvent.VK_SPACE, InputEvent.CTRL_DOWN_MASK));
        assertTrue(bench.paused);
    }

    private static void press(WindowBench bench) {
        press(bench, KeyStroke.getKeyStroke(KeyEvent.VK_F11, 0));
    }

    /** As Swing does it: the key's binding in a component that is shown. */
    private static void press(WindowBench bench, KeyStroke key) {
        JComponent bound = binding(bench.panel, key);
        assertTrue(bound != null && isShown(bound, bench.panel), "no component that is shown has " + key);
        Object id = bound.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).get(key);
        bound.getActionMap().get(id).actionPerformed(new ActionEvent(bound, 0, ""));
    }

    private static JComponent binding(Component root, KeyStroke key) {
        if (root instanceof JComponent component
                && component.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).get(key) != null) {
            return component;
        }
        if (root instanceof Container container) {
            for (Component child : container.getComponents()) {
                JComponent found = child.isVisible() ? binding(child, key) : null;
                if (found != null) {
                    return found;
                }
            }
        }
        return null;
    }

    @Test
    void everyControlHasAName() throws Exception {
        for (Locale language : List.of(Locale.ENGLISH, new Locale("es"))) {
            WindowBench bench = bench(language, 1100, 800);
            assertEquals(List.of(), ComponentNames.unnamed(bench.panel));
        }
    }

    @Test
    void onlyTheLitStatusReadsAsTrue() throws Exception {
        WindowBench bench = bench(Locale.ENGLISH, 1100, 800);
        assertEquals("Status: Stopped", bench.spoken("status.stopped"));
        assertEquals("Status: Collision, no", bench.spoken("status.collision"));
    }

    // ---- dividers

    private static Divider divider(WindowBench bench, String id) {
        return (Divider) bench.component("divider." + id);
    }

    private static void mouse(Component at, int id, int x, int y, int clicks) {
        int held = id == MouseEvent.MOUSE_RELEASED ? 0 : InputEvent.BUTTON1_DOWN_MASK;
        at.dispatchEvent(new MouseEvent(at, id, 0, held, x, y, clicks, false, MouseEvent.BUTTON1));
    }

    private static void drag(WindowBench bench, String id, int dx, int dy) {
        Divider divider = divider(bench, id);
        mouse(divider, MouseEvent.MOUSE_PRESSED, 3, 3, 1);
        mouse(divider, MouseEvent.MOUSE_DRAGGED, 3 + dx / 2, 3 + dy / 2, 1);
        mouse(divider, MouseEvent.MOUSE_DRAGGED, 3 + dx, 3 + dy, 1);
        mouse(divider, MouseEvent.MOUSE_RELEASED, 3 + dx, 3 + dy, 1);
        bench.resize(1100, 800).resize(1100, 800);
    }

    private static void press(WindowBench bench, String id, int key, int modifiers) {
        Divider divider = divider(bench, id);
        Object bound = divider.getInputMap().get(KeyStroke.getKeyStroke(key, modifiers));
        divider.getActionMap().get(bound).actionPerformed(new ActionEvent(divider, 0, ""));
        bench.resize(1100, 800).resize(1100, 800);
    }

    private static WindowBench inACall() throws Exception {
        WindowBench bench = new WindowBench("demo.map", Locale.ENGLISH, "anna");
        bench.lines = List.of(WindowBench.line("anna", true, false, WindowBench.noOrders(), ""));
        return bench.show().resize(1100, 800).resize(1100, 800);
    }

    @Test
    void dividersAreDraggedAndADoubleClickPutsThemBack() throws Exception {
        WindowBench bench = inACall();
        Component floor = bench.floor().getParent();
        int width = floor.getWidth();
        int height = floor.getHeight();
        drag(bench, "inspector", -60, 0);
        assertEquals(width - 60, floor.getWidth(), 1);
        drag(bench, "row", 0, 40);
        assertEquals(height + 40, floor.getHeight(), 1);
        drag(bench, "row", 0, -800);
        assertEquals(160, floor.getHeight(), 1, "the floor keeps its least height");
        mouse(divider(bench, "row"), MouseEvent.MOUSE_CLICKED, 3, 3, 2);
        mouse(divider(bench, "inspector"), MouseEvent.MOUSE_CLICKED, 3, 3, 2);
        bench.resize(1100, 800).resize(1100, 800);
        assertEquals(width, floor.getWidth());
        assertEquals(height, floor.getHeight());
    }

    @Test
    void dividersAreMovedByKeys() throws Exception {
        WindowBench bench = inACall();
        Component floor = bench.floor().getParent();
        int width = floor.getWidth();
        int height = floor.getHeight();
        press(bench, "inspector", KeyEvent.VK_LEFT, 0);
        press(bench, "inspector", KeyEvent.VK_UP, 0);
        assertEquals(width - 16, floor.getWidth());
        press(bench, "inspector", KeyEvent.VK_RIGHT, InputEvent.SHIFT_DOWN_MASK);
        assertEquals(width - 15, floor.getWidth());
        press(bench, "row", KeyEvent.VK_DOWN, 0);
        assertEquals(height + 16, floor.getHeight());
        press(bench, "row", KeyEvent.VK_HOME, 0);
        assertEquals(160, floor.getHeight(), 1, "the floor keeps its least height");
        press(bench, "row", KeyEvent.VK_END, 0);
        assertTrue(floor.getHeight() > height + 16, "the modem has its least height");
        press(bench, "row", KeyEvent.VK_ENTER, 0);
        press(bench, "inspector", KeyEvent.VK_ENTER, 0);
        assertEquals(width, floor.getWidth());
        assertEquals(height, floor.getHeight());
    }

    @Test
    void onlyDividersInAGapTakeTheFocus() throws Exception {
        WindowBench bench = inACall();
        assertTrue(divider(bench, "row").isVisible());
        assertTrue(divider(bench, "orders").isVisible());
        assertFalse(divider(bench, "column").isVisible());
        bench.resize(1900, 1000).resize(1900, 1000);
        assertFalse(divider(bench, "row").isVisible());
        assertTrue(divider(bench, "column").isVisible());
    }

    /** At 1366x768 the demo gives the window so little height that list and sheet did not both have room. */
    @Test
    void inALowWindowEachSheetHasTheWholeHeight() throws Exception {
        WindowBench bench = bench(Locale.ENGLISH, 1000, 440);
        press(bench, KeyStroke.getKeyStroke(KeyEvent.VK_3, InputEvent.ALT_DOWN_MASK));
        bench.resize(1000, 440).resize(1000, 440);
        assertTrue(bench.component("processes").getParent().getHeight() > 150);
        AbstractButton tab = (AbstractButton) bench.component("tab.processes");
        int needed = tab.getFontMetrics(tab.getFont()).stringWidth(tab.getText());
        assertTrue(tab.getWidth() - needed >= 6, tab.getWidth() + " for " + needed);
        bench.click("robot.add");
        assertTrue(((AbstractButton) bench.component("tab.robot")).isSelected());
    }
}
