package simgsm.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class KeycapsTest {
    @Test
    void anOrderThatFitsIsShownInOneRowAtFullSize() {
        assertEquals(new Keycaps.Grid(13, 1, 0, 1), Keycaps.Grid.of(9, 325, 34));
    }

    /** {@code **#*#180#**50**} has 15 keys. */
    @Test
    void aLongOrderIsShownWholeInTwoRowsOrSmaller() {
        assertEquals(new Keycaps.Grid(11, 2, 0, 1), Keycaps.Grid.of(15, 288, 68));
        Keycaps.Grid oneRow = Keycaps.Grid.of(15, 288, 34);
        assertEquals(0, oneRow.first());
        assertTrue(oneRow.scale() < 1 && oneRow.scale() >= 0.6, oneRow.toString());
    }

    @Test
    void anEllipsisStandsForTheFirstKeysOfATripThatDoesNotFit() {
        Keycaps.Grid grid = Keycaps.Grid.of(120, 288, 34);
        assertEquals(0.6, grid.scale(), 1e-9);
        assertEquals(120 - grid.inRow() * grid.rows() + 1, grid.first());
    }
}
