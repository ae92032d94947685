package simrobot.drawing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import simrobot.world.Area;

class ViewportTest {
    private final Viewport view = new Viewport(2, 3, 50, 400, 300);

    @Test
    void theMiddleIsInTheMiddleAndYRunsUp() {
        assertEquals(200, view.screenX(2));
        assertEquals(150, view.screenY(3));
        assertEquals(100, view.screenY(4));
        assertEquals(250, view.screenX(3));
    }

    @Test
    void screenAndWorldAreInverse() {
        assertEquals(17, view.screenX(view.worldX(17)), 1e-9);
        assertEquals(-8, view.screenY(view.worldY(-8)), 1e-9);
    }

    @Test
    void zoomingKeepsThePlaceUnderThePointer() {
        Viewport larger = view.zoomedAt(33, 44, 1.7);
        assertEquals(view.worldX(33), larger.worldX(33), 1e-9);
        assertEquals(view.worldY(44), larger.worldY(44), 1e-9);
        assertEquals(85, larger.pixelsPerMeter(), 1e-9);
    }

    @Test
    void zoomStaysWithinItsBounds() {
        assertEquals(2000, view.zoomedAt(0, 0, 1e9).pixelsPerMeter());
        assertEquals(0.5, view.zoomedAt(0, 0, 1e-9).pixelsPerMeter());
    }

    @Test
    void draggingTakesTheWorldAlong() {
        Viewport dragged = view.draggedBy(50, 25);
        assertEquals(view.screenX(0) + 50, dragged.screenX(0), 1e-9);
        assertEquals(view.screenY(0) + 25, dragged.screenY(0), 1e-9);
    }

    @Test
    void fittingShowsAllOfTheArea() {
        Viewport fit = Viewport.fitting(new Area(-10, -5, 10, 5, 0), 400, 300, 20);
        assertEquals(20, fit.screenX(-10), 1e-9);
        assertEquals(380, fit.screenX(10), 1e-9);
        assertTrue(fit.screenY(5) > 20);
    }

    @Test
    void whatIsFarOutsideIsNotShown() {
        assertTrue(view.shows(2, 3, 0));
        assertTrue(view.shows(-2.2, 3, 0.3));
        assertFalse(view.shows(-2.4, 3, 0.3));
    }
}
