package simrobot.ui.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.List;
import java.util.Locale;
import javax.swing.JLabel;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import simgsm.draw.Appearance;
import simgsm.ui.Theme;
import simrobot.drawing.NumberTexts;
import simrobot.drawing.RobotPainter;
import simrobot.robot.SimulatedRobot;
import simrobot.ui.panel.WindowBench;
import simrobot.world.Segment;
import simrobot.world.World;

/** The floor by mouse and by keyboard. */
class WorldViewTest {
    private WindowBench bench;
    private SimulatedRobot robot;
    private WorldView view;

    @BeforeEach
    void aRobotInTheEmptyHall() throws Exception {
        Theme.install(Appearance.LIGHT);
        bench = new WindowBench("empty.map", Locale.ENGLISH, "robot");
        robot = bench.simulation.robots().get(0);
        view = bench.floor();
    }

    private void mouse(int id, double xMeters, double yMeters, int button, int modifiers, int clicks) {
        int x = (int) Math.round(view.viewport().screenX(xMeters));
        int y = (int) Math.round(view.viewport().screenY(yMeters));
        MouseEvent event = new MouseEvent(view, id, 0, modifiers, x, y, clicks, false, button);
        view.dispatchEvent(event);
        bench.show();
    }

    private void drag(double fromX, double fromY, double toX, double toY, int button, int modifiers) {
        mouse(MouseEvent.MOUSE_PRESSED, fromX, fromY, button, modifiers, 1);
        mouse(MouseEvent.MOUSE_DRAGGED, toX, toY, button, modifiers, 1);
        mouse(MouseEvent.MOUSE_RELEASED, toX, toY, button, 0, 1);
    }

    @Test
    void aRobotIsDraggedWithTheMouse() {
        drag(0, 0, 3, 2, MouseEvent.BUTTON1, InputEvent.BUTTON1_DOWN_MASK);
        assertEquals(3, robot.xMeters(), 0.1);
        assertEquals(2, robot.yMeters(), 0.1);
        assertEquals(0, robot.headingRadians());
    }

    @Test
    void aRobotDraggedIntoAWallStaysWhereItLastFitted() {
        drag(0, 0, 10, 0, MouseEvent.BUTTON1, InputEvent.BUTTON1_DOWN_MASK);
        assertEquals(0, robot.xMeters());
    }

    @Test
    void aDragOfARobotThatIsRemovedMovesNoOtherRobot() throws Exception {
        bench.simulation.addRobot("other");
        bench.simulation.robot("other").orElseThrow().place(5, 5, 0);
        bench.show();
        mouse(MouseEvent.MOUSE_PRESSED, 0, 0, MouseEvent.BUTTON1, InputEvent.BUTTON1_DOWN_MASK, 1);
        mouse(MouseEvent.MOUSE_DRAGGED, 1, 1, MouseEvent.BUTTON1, InputEvent.BUTTON1_DOWN_MASK, 1);
        bench.simulation.removeRobot(robot);
        bench.show();
        mouse(MouseEvent.MOUSE_DRAGGED, 2, 2, MouseEvent.BUTTON1, InputEvent.BUTTON1_DOWN_MASK, 1);
        mouse(MouseEvent.MOUSE_RELEASED, 2, 2, MouseEvent.BUTTON1, 0, 1);
        assertEquals(5, bench.simulation.robot("other").orElseThrow().xMeters());
    }

    @Test
    void aPlaceThatIsNotWantedAnyMoreIsNotChosenByADrag() {
        bench.click("robot.add");
        mouse(MouseEvent.MOUSE_PRESSED, 4, 4, MouseEvent.BUTTON1, InputEvent.BUTTON1_DOWN_MASK, 1);
        bench.click("newcomer.cancel");
        mouse(MouseEvent.MOUSE_DRAGGED, 5, 4, MouseEvent.BUTTON1, InputEvent.BUTTON1_DOWN_MASK, 1);
        mouse(MouseEvent.MOUSE_RELEASED, 5, 4, MouseEvent.BUTTON1, 0, 1);
        assertTrue(view.placing().preview().isEmpty());
    }

    @Test
    void aRulerThatIsHiddenDuringADragStaysHidden() {
        view.toggleRuler();
        mouse(MouseEvent.MOUSE_PRESSED, 4, 4, MouseEvent.BUTTON1, InputEvent.BUTTON1_DOWN_MASK, 1);
        press(KeyEvent.VK_ESCAPE, 0);
        mouse(MouseEvent.MOUSE_DRAGGED, 5, 4, MouseEvent.BUTTON1, InputEvent.BUTTON1_DOWN_MASK, 1);
        assertNull(view.ruler());
    }

    @Test
    void theRightButtonTurnsARobotTowardsThePointerInWholeDegrees() {
        drag(0, 0, 0.001, 3, MouseEvent.BUTTON3, InputEvent.BUTTON3_DOWN_MASK);
        assertEquals(90, Math.toDegrees(robot.headingRadians()), 1e-9);
        assertEquals(0, robot.xMeters());
    }

    @Test
    void theHandleTurnsARobotWithShiftInStepsOfFifteenDegrees() {
        view.zoom(5);
        drag(
                RobotPainter.HANDLE_METERS,
                0,
                0.5,
                0.48,
                MouseEvent.BUTTON1,
                InputEvent.BUTTON1_DOWN_MASK | InputEvent.SHIFT_DOWN_MASK);
        assertEquals(45, Math.toDegrees(robot.headingRadians()), 1e-9);
    }

    @Test
    void draggingTheFloorPans() {
        double before = view.viewport().centerX();
        drag(5, 5, 4, 5, MouseEvent.BUTTON1, InputEvent.BUTTON1_DOWN_MASK);
        assertEquals(before + 1, view.viewport().centerX(), 0.1);
        assertEquals(0, robot.xMeters());
    }

    @Test
    void theWheelZoomsAtThePointerAndADoubleClickFits() {
        double fitted = view.viewport().pixelsPerMeter();
        double place = view.viewport().worldX(40);
        view.dispatchEvent(new MouseWheelEvent(
                view, MouseEvent.MOUSE_WHEEL, 0, 0, 40, 50, 0, false, MouseWheelEvent.WHEEL_UNIT_SCROLL, 1, -3));
        assertTrue(view.viewport().pixelsPerMeter() > 1.4 * fitted);
        assertEquals(place, view.viewport().worldX(40), 1e-9);
        mouse(
                MouseEvent.MOUSE_CLICKED,
                view.viewport().worldX(40),
                view.viewport().worldY(50),
                MouseEvent.BUTTON1,
                0,
                2);
        assertEquals(fitted, view.viewport().pixelsPerMeter(), 1e-9);
    }

    private void press(int key, int modifiers) {
        Object id = view.getInputMap().get(KeyStroke.getKeyStroke(key, modifiers));
        view.getActionMap().get(id).actionPerformed(new ActionEvent(view, ActionEvent.ACTION_PERFORMED, ""));
        bench.show();
    }

    @Test
    void altAndArrowsMoveTheRobotAndPageKeysTurnIt() {
        press(KeyEvent.VK_RIGHT, InputEvent.ALT_DOWN_MASK);
        press(KeyEvent.VK_RIGHT, InputEvent.ALT_DOWN_MASK);
        press(KeyEvent.VK_UP, InputEvent.ALT_DOWN_MASK);
        press(KeyEvent.VK_PAGE_UP, InputEvent.ALT_DOWN_MASK);
        assertEquals(0.2, robot.xMeters(), 1e-9);
        assertEquals(0.1, robot.yMeters(), 1e-9);
        assertEquals(5, Math.toDegrees(robot.headingRadians()), 1e-9);
    }

    @Test
    void arrowsPanPlusZoomsAndHomeFits() {
        double fitted = view.viewport().pixelsPerMeter();
        press(KeyEvent.VK_RIGHT, 0);
        assertTrue(view.viewport().centerX() > 0.5);
        press(KeyEvent.VK_PLUS, 0);
        assertEquals(1.25 * fitted, view.viewport().pixelsPerMeter(), 1e-9);
        press(KeyEvent.VK_HOME, 0);
        assertEquals(fitted, view.viewport().pixelsPerMeter(), 1e-9);
        assertEquals(0, view.viewport().centerX());
    }

    @Test
    void theClockShowsSimulatedTime() {
        assertEquals("0:00:00.00", NumberTexts.clock(0));
        assertEquals("1:01:01.23", NumberTexts.clock(3_661_230_000_000L));
    }

    @Test
    void atRestTheClockHasWholeSecondsAndWhilePausedEachStep() {
        JLabel clock = (JLabel) bench.component("world.clock");
        bench.simulation.run(1);
        bench.show();
        bench.simulation.run(100);
        bench.show();
        assertEquals("0:00:01", clock.getText());
        bench.simulation.run(1);
        bench.show();
        assertEquals("0:00:01.02", clock.getText());
    }

    @Test
    void aFloorAtRestDiffersFromOneThatMoves() {
        bench.simulation.step();
        var before = bench.simulation.snapshot();
        bench.simulation.step();
        assertTrue(SnapshotComparison.looksTheSame(before, bench.simulation.snapshot()));
        robot.place(1, 1, 0);
        assertFalse(SnapshotComparison.looksTheSame(before, bench.simulation.snapshot()));
    }

    /** On the map of a whole building the robot would be a few pixels wide. */
    @Test
    void aLargeFloorIsShownAroundTheRobotFirstAndHomeShowsAllOfIt() {
        bench.simulation.load(World.of("large", List.of(new Segment(-60, -60, 60, 60))));
        bench.show();
        assertEquals(40, view.viewport().pixelsPerMeter(), 1e-9);
        assertEquals(robot.xMeters(), view.viewport().centerX(), 1e-9);
        assertEquals(robot.yMeters(), view.viewport().centerY(), 1e-9);
        bench.resize(900, 700);
        assertEquals(robot.xMeters(), view.viewport().centerX(), 1e-9);
        view.fit();
        assertTrue(view.viewport().shows(-60, -60, 0) && view.viewport().shows(60, 60, 0));
    }
}
