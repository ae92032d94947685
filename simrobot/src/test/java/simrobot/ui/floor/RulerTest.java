package simrobot.ui.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.util.Locale;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.ui.Theme;
import simrobot.drawing.Ruler;
import simrobot.drawing.Viewport;
import simrobot.ui.panel.WindowBench;
import simrobot.world.Position;

class RulerTest {
    private WindowBench bench;

    @BeforeEach
    void anEmptyRoom() throws Exception {
        Theme.install(Appearance.LIGHT);
        bench = new WindowBench("empty.map", Locale.ENGLISH, "robot");
        bench.simulation.robots().get(0).place(0, 0, Math.PI / 2);
        bench.show();
    }

    @Test
    void distanceAndDirectionAreRead() {
        Ruler ruler = new Ruler(new Position(1, 1), new Position(-2, 5));
        assertEquals("5.000 m  126.9\u00b0", ruler.text());
    }

    @Test
    void itIsLaidAheadOfTheRobotAndPutAwayAgain() {
        bench.command("tool.ruler");
        assertEquals("Ruler: 1.000 m  90.0\u00b0", bench.spoken("world"));
        bench.command("tool.ruler");
        assertNull(bench.floor().ruler());
    }

    @Test
    void draggingMeasuresAndLeavesTheRobotWhereItIs() {
        bench.command("tool.ruler");
        mouse(MouseEvent.MOUSE_PRESSED, 2, 2);
        mouse(MouseEvent.MOUSE_DRAGGED, 5, 2);
        mouse(MouseEvent.MOUSE_RELEASED, 5, 2);
        assertEquals(3, bench.floor().ruler().meters(), 0.07);
        mouse(MouseEvent.MOUSE_PRESSED, 5, 2);
        mouse(MouseEvent.MOUSE_DRAGGED, 2, 6);
        assertEquals(4, bench.floor().ruler().meters(), 0.07);
        assertEquals(0, bench.simulation.robots().get(0).xMeters());
    }

    @Test
    void itSticksToARobotsMiddle() {
        bench.command("tool.ruler");
        mouse(MouseEvent.MOUSE_PRESSED, 3, 0);
        mouse(MouseEvent.MOUSE_DRAGGED, 0.1, 0.1);
        assertEquals(new Position(0, 0), bench.floor().ruler().to());
    }

    @Test
    void itsEndsMoveByKeyboard() {
        bench.command("tool.ruler");
        act("world.pan.39");
        assertEquals(0.05, bench.floor().ruler().to().xMeters(), 1e-9);
        act("world.ruler.40");
        assertEquals(-0.05, bench.floor().ruler().from().yMeters(), 1e-9);
        act("world.letGo");
        assertNull(bench.floor().ruler());
    }

    @Test
    void itIsPaintedWithItsNumbers() {
        // Four times as large: a thin line between two pixels has the colour of neither.
        int before = WindowBench.count(WindowBench.painted(bench.floor(), 4), Ink.ACCENT);
        bench.command("tool.ruler");
        assertTrue(WindowBench.count(WindowBench.painted(bench.floor(), 4), Ink.ACCENT) > before + 400);
    }

    private void act(String id) {
        bench.floor().getActionMap().get(id).actionPerformed(null);
    }

    private void mouse(int id, double x, double y) {
        Viewport view = bench.floor().viewport();
        bench.floor()
                .dispatchEvent(new MouseEvent(
                        bench.floor(),
                        id,
                        0,
                        InputEvent.BUTTON1_DOWN_MASK,
                        (int) Math.round(view.screenX(x)),
                        (int) Math.round(view.screenY(y)),
                        1,
                        false,
                        MouseEvent.BUTTON1));
    }
}
