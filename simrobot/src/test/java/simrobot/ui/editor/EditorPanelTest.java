package simrobot.ui.editor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JPopupMenu;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.ui.Theme;
import simrobot.drawing.Viewport;
import simrobot.editor.Item;
import simrobot.ui.panel.WindowBench;
import simrobot.ui.panel.WorldChoice;
import simrobot.world.Area;
import simrobot.world.Box;
import simrobot.world.Home;
import simrobot.world.MapWriter;
import simrobot.world.Segment;
import simrobot.world.Treadmill;
import simrobot.world.World;
import simrobot.world.WorldReader;

/** A world is drawn, changed, saved and put under the robots, by mouse and by keyboard. */
class EditorPanelTest {
    @TempDir
    Path folder;

    private WindowBench bench;
    private EditorView floor;

    @BeforeEach
    void theEditorOverAnEmptyRoom() throws Exception {
        Theme.install(Appearance.LIGHT);
        bench = new WindowBench("empty.map", Locale.ENGLISH, "robot");
        menu("world.edit");
        floor = (EditorView) bench.component("editor.floor");
        layOut();
    }

    private void menu(String id) {
        JPopupMenu menu = worldChoice().menu();
        for (Component entry : menu.getComponents()) {
            if (entry instanceof javax.swing.JMenuItem item
                    && item.getActionCommand().equals(id)) {
                item.doClick(0);
                return;
            }
        }
        throw new AssertionError("no entry " + id);
    }

    private WorldChoice worldChoice() {
        return bench.panel.worldChoice();
    }

    private void layOut() {
        bench.resize(1100, 760);
        for (var listener : floor.getComponentListeners()) {
            listener.componentResized(null);
        }
    }

    private List<Segment> walls() {
        return floor.draft().world().items(Segment.class);
    }

    @Test
    void timeStandsStillWhileAWorldIsEditedAndGoesOnAfterwards() {
        assertTrue(bench.paused);
        bench.click("editor.back");
        assertFalse(bench.paused);
        assertFalse(bench.component("editor").isVisible());
    }

    @Test
    void aWallIsDrawnOnTheRasterSelectedAndUndone() {
        int before = walls().size();
        bench.click("editor.tool.wall");
        drag(1.01, 2.01, 3.99, 3.01, 0);
        assertEquals(new Segment(1, 2, 4, 3), walls().get(before));
        assertEquals(Optional.of(new Item(Segment.KIND, before)), floor.draft().selected());
        assertEquals("4", field("x2").getText());
        bench.click("editor.undo");
        assertEquals(before, walls().size());
        bench.click("editor.redo");
        assertEquals(before + 1, walls().size());
    }

    @Test
    void withShiftAWallIsStraight() {
        int before = walls().size();
        bench.click("editor.tool.wall");
        drag(1, 2, 4, 2.4, InputEvent.SHIFT_DOWN_MASK);
        assertEquals(new Segment(1, 2, 4, 2), walls().get(before));
    }

    @Test
    void homesBoxesAndTreadmillsArePlaced() {
        bench.click("editor.tool.home");
        drag(1, 1, 1, 2, 0);
        bench.click("editor.tool.box");
        drag(3, 3, 4, 4, 0);
        bench.click("editor.tool.treadmill");
        drag(-4, -4, -2, -3, 0);
        var world = floor.draft().world();
        assertEquals(
                90,
                Math.toDegrees(world.items(Home.class)
                        .get(world.items(Home.class).size() - 1)
                        .headingRadians()),
                3);
        assertEquals(1, world.items(Box.class).size());
        assertEquals(1, world.items(Treadmill.class).size());
        type("speed", "-0.5");
        assertEquals(-0.5, floor.draft().world().items(Treadmill.class).get(0).speedMetersPerSecond());
        type("speed", "fast");
        assertEquals("speed, m/s: expected a number, found fast", bench.spoken("editor.problem"));
    }

    @Test
    void anEndIsPulledAWallMovedAndDeleted() {
        bench.click("editor.tool.wall");
        drag(1, 2, 4, 2, 0);
        int last = walls().size() - 1;
        bench.click("editor.tool.select");
        drag(4, 2, 5, 3, 0);
        assertEquals(new Segment(1, 2, 5, 3), walls().get(last));
        drag(3, 2.5, 3.5, 2.5, 0);
        assertEquals(new Segment(1.5, 2, 5.5, 3), walls().get(last));
        bench.click("editor.delete");
        assertEquals(last, walls().size());
    }

    @Test
    void everythingCanBeDoneByKeyboard() {
        int before = walls().size();
        bench.click("editor.tool.wall");
        act("editor.insert");
        assertEquals(before + 1, walls().size());
        Segment made = walls().get(before);
        act("editor.arrow.39");
        assertEquals(made.x1Meters() + 0.1, walls().get(before).x1Meters(), 1e-9);
        act("editor.erase");
        assertEquals(before, walls().size());
        ((JList<?>) bench.component("editor.items")).setSelectedIndex(0);
        assertTrue(floor.draft().selected().isPresent());
        act("editor.letGo");
        assertFalse(floor.draft().selected().isPresent());
    }

    private void act(String id) {
        ((JComponent) floor).getActionMap().get(id).actionPerformed(null);
    }

    @Test
    void whatIsSavedLoadsToExactlyTheSameWorld() throws Exception {
        bench.click("editor.tool.wall");
        drag(1, 2, 4, 2.3, 0);
        Path file = folder.resolve("mine.map");
        editor().write(file, () -> {});
        bench.settle();
        assertEquals(floor.draft().world().named("mine.map"), WorldReader.read(file));
        assertTrue(bench.spoken("editor.state").startsWith("Saved as "));
        assertEquals("mine.map", bench.spoken("editor.file"));
    }

    @Test
    void whatCannotBeSavedIsSaid() throws Exception {
        bench.click("editor.tool.wall");
        drag(1, 2, 4, 2.3, 0);
        editor().write(folder.resolve("nowhere").resolve("mine.map"), () -> {});
        bench.settle();
        assertTrue(bench.spoken("editor.state").endsWith("the folder does not exist"));
        assertEquals("empty.map \u2013 changed", bench.spoken("editor.file"));
    }

    @Test
    void aDraftThatWasNeverSavedIsOfferedWhenTheFileIsOpenedAgain() throws Exception {
        Path file = folder.resolve("room.map");
        World saved = WindowBench.world("empty.map").named("room.map");
        MapWriter.save(saved, file);
        editor().edit(saved, file, true, List.of());
        assertFalse(bench.component("editor.restore").isVisible());
        bench.click("editor.tool.wall");
        drag(1, 2, 4, 2.3, 0);
        World draft = floor.draft().committed();
        editor().keepDraft();
        bench.settle();

        editor().edit(saved, file, true, List.of());
        assertEquals(saved, floor.draft().committed());
        assertTrue(bench.component("editor.restore").isVisible());
        bench.click("editor.restore");
        assertEquals(draft.named("room.map"), floor.draft().committed().named("room.map"));
        assertFalse(bench.component("editor.restore").isVisible());
        editor().write(file, () -> {});
        bench.settle();

        editor().edit(WorldReader.read(file), file, true, List.of());
        assertFalse(bench.component("editor.restore").isVisible());
        assertEquals(List.of(file), List.of(Files.list(folder).toArray()));
    }

    @Test
    void aWindowWithoutUnsavedChangesClosesAtOnce() {
        List<String> done = new ArrayList<>();
        editor().leave(() -> done.add("closed"));
        assertEquals(List.of("closed"), done);
    }

    private EditorPanel editor() {
        return (EditorPanel) bench.component("editor");
    }

    @Test
    void applyPutsTheWorldUnderTheRobotsAndMovesARobotOutOfAWall() throws Exception {
        var robot = bench.simulation.robots().get(0);
        double x = robot.xMeters();
        double y = robot.yMeters();
        bench.click("editor.tool.wall");
        drag(x - 1, y, x + 1, y, 0);
        bench.click("editor.apply");
        bench.settle();
        assertEquals(walls(), bench.simulation.world().items(Segment.class));
        assertTrue(Math.abs(robot.yMeters() - y) >= 0.25 || Math.abs(robot.xMeters() - x) >= 1);
        assertFalse(bench.component("editor.apply").isEnabled());
    }

    @Test
    void aWallIsDrawnMovedAndDeletedByKeysAlone() {
        int before = walls().size();
        press(editor(), JComponent.WHEN_IN_FOCUSED_WINDOW, KeyEvent.VK_W, InputEvent.ALT_DOWN_MASK);
        key(KeyEvent.VK_ENTER, 0);
        Segment made = walls().get(before);
        key(KeyEvent.VK_UP, 0);
        Segment moved = new Segment(made.x1Meters(), made.y1Meters() + 0.1, made.x2Meters(), made.y2Meters() + 0.1);
        assertEquals(moved, walls().get(before));
        key(KeyEvent.VK_RIGHT, InputEvent.SHIFT_DOWN_MASK);
        key(KeyEvent.VK_UP, InputEvent.SHIFT_DOWN_MASK);
        Segment pulled = walls().get(before);
        assertEquals(moved.x1Meters(), pulled.x1Meters(), 1e-9);
        assertEquals(moved.y1Meters(), pulled.y1Meters(), 1e-9);
        assertEquals(moved.x2Meters() + 0.1, pulled.x2Meters(), 1e-9);
        assertEquals(moved.y2Meters() + 0.1, pulled.y2Meters(), 1e-9);
        JComponent items = (JComponent) bench.component("editor.items");
        press(items, JComponent.WHEN_FOCUSED, KeyEvent.VK_DELETE, 0);
        assertEquals(before, walls().size());
    }

    @Test
    void aBoxIsMadeLargerByKeys() {
        press(editor(), JComponent.WHEN_IN_FOCUSED_WINDOW, KeyEvent.VK_B, InputEvent.ALT_DOWN_MASK);
        key(KeyEvent.VK_ENTER, 0);
        Area made = floor.draft().world().items(Box.class).get(0).area();
        key(KeyEvent.VK_RIGHT, InputEvent.SHIFT_DOWN_MASK);
        Area larger = floor.draft().world().items(Box.class).get(0).area();
        assertEquals(made.maxXMeters() + 0.1, larger.maxXMeters(), 1e-9);
        assertEquals(made.minXMeters(), larger.minXMeters(), 1e-9);
    }

    @Test
    void aHomeInABoxIsWarnedOfAndShownUntilItIsFree() {
        bench.click("editor.tool.box");
        drag(1, 1, 2, 2, 0);
        int free = WindowBench.count(WindowBench.painted(floor, 1), Ink.DANGER);
        bench.click("editor.tool.home");
        drag(1.5, 1.5, 2.5, 1.5, 0);
        assertTrue(bench.spoken("editor.state").startsWith("No robot fits at Home"), bench.spoken("editor.state"));
        assertTrue(bench.spoken("editor.state").contains("0.25 m"), bench.spoken("editor.state"));
        assertTrue(WindowBench.count(WindowBench.painted(floor, 1), Ink.DANGER) > free + 20);
        type("x", "3.5");
        assertFalse(bench.spoken("editor.state").contains("fits"), bench.spoken("editor.state"));
    }

    private void key(int code, int modifiers) {
        press(floor, JComponent.WHEN_FOCUSED, code, modifiers);
    }

    private static void press(JComponent at, int condition, int code, int modifiers) {
        Object id = at.getInputMap(condition).get(KeyStroke.getKeyStroke(code, modifiers));
        at.getActionMap().get(id).actionPerformed(new ActionEvent(at, 0, ""));
    }

    @Test
    void aNewWorldIsEmpty() {
        bench.click("editor.back");
        menu("world.new");
        assertEquals(0, walls().size());
        assertEquals("new.map \u2013 changed", bench.spoken("editor.file"));
    }

    // ---- hands
    // -------------------------------------------------------------------------------------------------------

    private JTextField field(String key) {
        return (JTextField) bench.component("editor.field." + key);
    }

    private void type(String key, String text) {
        field(key).setText(text);
        field(key).postActionEvent();
    }

    @Test
    void whileAWallIsDraggedTheRestOfTheFloorIsPaintedFromOnePicture() {
        bench.click("editor.tool.wall");
        drag(1, 2, 4, 2, 0);
        bench.click("editor.tool.select");
        mouse(MouseEvent.MOUSE_PRESSED, 2, 2, 0);
        mouse(MouseEvent.MOUSE_DRAGGED, 2, 3, 0);
        WindowBench.painted(floor, 1);
        World rest = floor.draft().background();
        mouse(MouseEvent.MOUSE_DRAGGED, 2, 4, 0);
        assertSame(rest, floor.draft().background());
        int there = WindowBench.count(WindowBench.painted(floor, 1), Ink.ACCENT);
        mouse(MouseEvent.MOUSE_RELEASED, 2, 4, 0);
        assertEquals(new Segment(1, 4, 4, 4), walls().get(walls().size() - 1));
        assertEquals(there, WindowBench.count(WindowBench.painted(floor, 1), Ink.ACCENT), 200);
        assertSame(floor.draft().world(), floor.draft().background());
    }

    /** A wall from (1, 2) to (4, 2), and the mouse that drags from a place on it or at its end. */
    private void wallUnderTheMouse(double x, double y) {
        bench.click("editor.tool.wall");
        drag(1, 2, 4, 2, 0);
        bench.click("editor.tool.select");
        mouse(MouseEvent.MOUSE_PRESSED, x, y, 0);
        mouse(MouseEvent.MOUSE_DRAGGED, x, y + 0.5, 0);
    }

    private void dragOnAndRelease() {
        mouse(MouseEvent.MOUSE_DRAGGED, 3, 3.5, 0);
        mouse(MouseEvent.MOUSE_DRAGGED, 3, 4, 0);
        mouse(MouseEvent.MOUSE_RELEASED, 3, 4, 0);
    }

    @ParameterizedTest
    @CsvSource({"4, editor.undo", "4, editor.delete", "2, editor.undo", "2, editor.delete"})
    void aDragEndsWithoutEffectWhenItsItemIsUndoneOrDeleted(double x, String action) {
        int before = walls().size();
        wallUnderTheMouse(x, 2);
        bench.click(action);
        List<Segment> rest = walls();
        assertEquals(before, rest.size());
        dragOnAndRelease();
        assertEquals(rest, walls());
    }

    @Test
    void aDragEndsWithoutEffectWhenAnotherItemTakesItsPlaceInTheWorld() {
        bench.click("editor.tool.wall");
        drag(1, 6, 4, 6, 0);
        wallUnderTheMouse(4, 2);
        act("editor.erase");
        bench.click("editor.undo");
        bench.click("editor.undo");
        List<Segment> rest = walls();
        dragOnAndRelease();
        assertEquals(rest, walls());
    }

    @Test
    void aDrawingEndsWithoutEffectWhenTheToolIsChanged() {
        int before = walls().size();
        bench.click("editor.tool.wall");
        mouse(MouseEvent.MOUSE_PRESSED, 1, 2, 0);
        mouse(MouseEvent.MOUSE_DRAGGED, 4, 2, 0);
        bench.click("editor.tool.select");
        mouse(MouseEvent.MOUSE_RELEASED, 4, 2, 0);
        assertEquals(before, walls().size());
    }

    private void drag(double x1, double y1, double x2, double y2, int modifiers) {
        mouse(MouseEvent.MOUSE_PRESSED, x1, y1, modifiers);
        mouse(MouseEvent.MOUSE_DRAGGED, (x1 + x2) / 2, (y1 + y2) / 2, modifiers);
        mouse(MouseEvent.MOUSE_DRAGGED, x2, y2, modifiers);
        mouse(MouseEvent.MOUSE_RELEASED, x2, y2, modifiers);
    }

    private void mouse(int id, double x, double y, int modifiers) {
        Viewport view = floor.viewport();
        floor.dispatchEvent(new MouseEvent(
                floor,
                id,
                0,
                modifiers | InputEvent.BUTTON1_DOWN_MASK,
                (int) Math.round(view.screenX(x)),
                (int) Math.round(view.screenY(y)),
                1,
                false,
                MouseEvent.BUTTON1));
    }
}
