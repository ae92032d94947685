package simrobot.editor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simrobot.world.Home;
import simrobot.world.Segment;
import simrobot.world.World;

class DraftTest {
    private static final Segment WALL = new Segment(0, 0, 1, 0);
    private final Draft draft = new Draft(World.bare());

    private static World with(World world, Segment wall) {
        return Edits.with(world, wall);
    }

    @Test
    void stepsAreUndoneAndRedoneInTheirOrder() {
        World none = draft.world();
        draft.change(with(draft.world(), WALL));
        World one = draft.world();
        draft.change(with(draft.world(), new Segment(1, 0, 1, 1)));
        draft.undo();
        assertSame(one, draft.world());
        draft.undo();
        assertSame(none, draft.world());
        assertFalse(draft.canUndo());
        draft.redo();
        draft.redo();
        assertEquals(2, draft.world().items(Segment.class).size());
        assertFalse(draft.canRedo());
    }

    @Test
    void aNewStepEndsWhatCouldBeRedone() {
        draft.change(with(draft.world(), WALL));
        draft.undo();
        draft.change(with(draft.world(), new Segment(5, 5, 6, 6)));
        assertFalse(draft.canRedo());
    }

    @Test
    void whatStandsStillWhileSomethingIsMadeOrMovedIsOneWorld() {
        World bare = draft.world();
        draft.preview(with(draft.committed(), WALL));
        assertEquals(Optional.of(new Item(Segment.KIND, 0)), draft.moving());
        assertSame(bare, draft.background());
        draft.commit();
        assertEquals(Optional.empty(), draft.moving());
        assertSame(draft.world(), draft.background());
        Item wall = new Item(Segment.KIND, 0);
        draft.select(wall);
        draft.preview(Edits.moved(draft.committed(), wall, 1, 0));
        World still = draft.background();
        assertEquals(List.of(), still.items(Segment.class));
        draft.preview(Edits.moved(draft.committed(), wall, 2, 0));
        assertSame(still, draft.background());
        assertEquals(Optional.of(wall), draft.moving());
        draft.discard();
        assertSame(draft.world(), draft.background());
    }

    @Test
    void aDragIsOneStepHoweverManyTriesItTook() {
        for (int i = 1; i < 20; i++) {
            draft.preview(with(draft.committed(), new Segment(0, 0, i, 0)));
            assertEquals(i, draft.world().items(Segment.class).get(0).x2Meters());
        }
        draft.commit();
        assertEquals(1, draft.world().items(Segment.class).size());
        draft.undo();
        assertEquals(0, draft.world().items(Segment.class).size());
    }

    @Test
    void aTryThatIsForgottenOrChangesNothingLeavesNoStep() {
        draft.preview(with(draft.committed(), WALL));
        draft.discard();
        draft.commit();
        draft.preview(draft.committed().named(draft.committed().name()));
        draft.commit();
        assertFalse(draft.canUndo());
        assertFalse(draft.isChanged());
    }

    @Test
    void itIsChangedUntilItIsSavedAndAgainAfterUndo() {
        draft.change(with(draft.world(), WALL));
        assertTrue(draft.isChanged());
        draft.markSaved(draft.world());
        assertFalse(draft.isChanged());
        draft.undo();
        assertTrue(draft.isChanged());
    }

    @Test
    void whatIsGoneIsNotSelected() {
        draft.change(with(draft.world(), WALL));
        draft.select(new Item(Segment.KIND, 0));
        draft.undo();
        assertEquals(Optional.empty(), draft.selected());
        draft.select(new Item(Home.KIND, 3));
        assertEquals(Optional.empty(), draft.selected());
    }

    @Test
    void theSelectedItemIsDeleted() {
        draft.change(with(with(draft.world(), WALL), new Segment(5, 5, 6, 6)));
        draft.select(new Item(Segment.KIND, 0));
        draft.deleteSelected();
        assertEquals(List.of(new Segment(5, 5, 6, 6)), draft.world().items(Segment.class));
        draft.deleteSelected();
        assertEquals(1, draft.world().items(Segment.class).size());
    }
}
