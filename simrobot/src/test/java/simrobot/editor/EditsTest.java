package simrobot.editor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import simrobot.world.Area;
import simrobot.world.Box;
import simrobot.world.Home;
import simrobot.world.ItemKind;
import simrobot.world.ItemKinds;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.Treadmill;
import simrobot.world.World;

/** Every kind of thing is made, moved, pulled, typed and found. */
class EditsTest {
    private World world;

    @BeforeEach
    void oneOfEach() {
        world = Edits.with(World.bare(), new Segment(0, 0, 3, 0));
        world = Edits.with(world, new Box("Desk", Area.between(1, 1, 2, 3, 0)));
        world = Edits.with(world, new Home("A", new Position(5, 5), Math.PI / 2, Optional.empty()));
        world = Edits.with(world, new Treadmill(Area.between(7, 0, 8, 4, 0), -0.3, 0));
    }

    @ParameterizedTest
    @MethodSource("simrobot.world.ItemKinds#edited")
    void movingThereAndBackChangesNothing(ItemKind<?> kind) {
        Item item = new Item(kind, 0);
        World there = Edits.moved(world, item, 0.1, -0.7);
        assertEquals(world, Edits.moved(there, item, -0.1, 0.7));
    }

    @ParameterizedTest
    @MethodSource("simrobot.world.ItemKinds#edited")
    void whatIsDeletedIsGoneAndNothingElse(ItemKind<?> kind) {
        World less = Edits.without(world, new Item(kind, 0));
        for (ItemKind<?> each : ItemKinds.ALL) {
            int gone = each == kind ? 1 : 0;
            assertEquals(Edits.count(world, each) - gone, Edits.count(less, each), each.word());
        }
    }

    @Test
    void aHomeIsBlockedWhereARobotWouldOverlapABoxOrAWall() {
        assertEquals(List.of(), Edits.blockedHomes(world, 0.25));
        World inTheDesk = Edits.moved(world, new Item(Home.KIND, 0), -3.5, -3);
        assertEquals(inTheDesk.items(Home.class), Edits.blockedHomes(inTheDesk, 0.25));
        World atTheWall = Edits.moved(world, new Item(Home.KIND, 0), -3.5, -4.8);
        assertEquals(atTheWall.items(Home.class), Edits.blockedHomes(atTheWall, 0.25));
        assertEquals(List.of(), Edits.blockedHomes(atTheWall, 0.15));
    }

    @Test
    void tenStepsOfATenthAreAMetreWithoutDust() {
        Item wall = new Item(Segment.KIND, 0);
        for (int i = 0; i < 10; i++) {
            world = Edits.moved(world, wall, 0.1, 0.1);
        }
        assertEquals(new Segment(1, 1, 4, 1), world.items(Segment.class).get(0));
    }

    @Test
    void anEndOfAWallIsPulled() {
        Handle end = Edits.handles(world, new Item(Segment.KIND, 0)).get(1);
        assertEquals(
                new Segment(0, 0, 4, 2),
                Edits.pulled(world, end, 4, 2).items(Segment.class).get(0));
        Handle begin = Edits.handles(world, new Item(Segment.KIND, 0)).get(0);
        assertEquals(
                new Segment(-1, 2, 3, 0),
                Edits.pulled(world, begin, -1, 2).items(Segment.class).get(0));
    }

    @ParameterizedTest
    @CsvSource({"0,0,0,2,3", "1,5,0,1,3", "2,5,9,1,1", "3,0,9,2,1"})
    void aCornerIsPulledWhileTheOneOppositeStays(int corner, double x, double y, double fixedX, double fixedY) {
        Handle handle = Edits.handles(world, new Item(Box.KIND, 0)).get(corner);
        Area area = Edits.pulled(world, handle, x, y).items(Box.class).get(0).area();
        assertEquals(Area.between(x, y, fixedX, fixedY, 0), area);
    }

    @Test
    void aTurnedBoxFollowsTheHandAllTheSame() {
        World turned = Edits.with(World.bare(), new Box("", new Area(1, 1, 2, 2, Math.PI / 2)));
        Item item = new Item(Box.KIND, 0);
        Position before = turned.items(Box.class).get(0).area().center();
        Position after =
                Edits.moved(turned, item, 1, 0).items(Box.class).get(0).area().center();
        assertEquals(before.xMeters() + 1, after.xMeters(), 1e-9);
        assertEquals(before.yMeters(), after.yMeters(), 1e-9);
    }

    @Test
    void aHomeIsTurnedByItsHandleInWholeDegrees() {
        Handle handle = Edits.handles(world, new Item(Home.KIND, 0)).get(0);
        assertEquals(5, handle.place().xMeters(), 1e-9);
        assertEquals(5.6, handle.place().yMeters(), 1e-9);
        Home turned = Edits.pulled(world, handle, 4, 5.001).items(Home.class).get(0);
        assertEquals(180, Math.toDegrees(turned.headingRadians()), 1e-9);
    }

    @Test
    void aNewHomeGetsANameThatNoneHas() {
        assertEquals("Home2", drawnHome(world).name());
        assertEquals(
                "Home4",
                drawnHome(Edits.with(world, new Home("Home3", new Position(0, 0), 0)))
                        .name());
    }

    private static Home drawnHome(World world) {
        return (Home) Home.KIND.drawn(world, new Position(0, 0), new Position(0, 0));
    }

    // ---- typed
    // -------------------------------------------------------------------------------------------------------

    @ParameterizedTest
    @MethodSource("simrobot.world.ItemKinds#edited")
    void fieldsThatWereNotTouchedLeaveTheWorldAsItIs(ItemKind<?> kind) throws Exception {
        Item item = new Item(kind, 0);
        assertSame(world, ItemFields.changed(world, item, ItemFields.of(world, item)));
    }

    private World typed(ItemKind<?> kind, String field, String text) throws ItemFields.FieldRefusal {
        Item item = new Item(kind, 0);
        Map<String, String> fields = new LinkedHashMap<>(ItemFields.of(world, item));
        assertEquals(true, fields.containsKey(field));
        fields.put(field, text);
        return ItemFields.changed(world, item, fields);
    }

    @Test
    void whatIsTypedIsSo() throws Exception {
        assertEquals(
                4.5,
                typed(Segment.KIND, "x2", "4,5").items(Segment.class).get(0).x2Meters());
        assertEquals(
                "Table",
                typed(Box.KIND, "name", " Table ").items(Box.class).get(0).name());
        assertEquals(
                Math.toRadians(45),
                typed(Home.KIND, "heading", "45").items(Home.class).get(0).headingRadians());
        assertEquals(
                0.25,
                typed(Treadmill.KIND, "speed", ".25")
                        .items(Treadmill.class)
                        .get(0)
                        .speedMetersPerSecond());
    }

    @ParameterizedTest
    @CsvSource({"wall,x1,abc", "wall,y2,''", "box,x1,1e3", "home,heading,400", "treadmill,speed,11", "wall,x1,999999"})
    void whatIsNoNumberIsRefusedByItsField(String word, String field, String text) {
        ItemKind<?> kind = ItemKinds.edited()
                .filter(each -> each.word().equals(word))
                .findFirst()
                .orElseThrow();
        ItemFields.FieldRefusal refusal = assertThrows(ItemFields.FieldRefusal.class, () -> typed(kind, field, text));
        assertEquals(field, refusal.field());
        assertEquals(text, refusal.getMessage());
    }

    // ---- found
    // -------------------------------------------------------------------------------------------------------

    @Test
    void whatLiesUnderThePointerIsFound() {
        assertEquals(Optional.of(new Item(Segment.KIND, 0)), Picking.itemAt(world, 1.5, 0.04, 0.05));
        assertEquals(Optional.empty(), Picking.itemAt(world, 1.5, 0.06, 0.05));
        assertEquals(Optional.of(new Item(Box.KIND, 0)), Picking.itemAt(world, 1.5, 2, 0.05));
        assertEquals(Optional.of(new Item(Home.KIND, 0)), Picking.itemAt(world, 5.2, 5, 0.05));
        assertEquals(Optional.of(new Item(Treadmill.KIND, 0)), Picking.itemAt(world, 7.5, 2, 0.05));
    }

    @Test
    void theNearestHandleIsTaken() {
        Item wall = new Item(Segment.KIND, 0);
        assertEquals(
                1, Picking.handleAt(world, wall, 2.95, 0, 0.1).orElseThrow().number());
        assertEquals(Optional.empty(), Picking.handleAt(world, wall, 2, 0, 0.1));
    }

    // ---- snapped
    // -----------------------------------------------------------------------------------------------------

    @Test
    void placesFallOnTheRasterAndOnWallEndsThatAreNear() {
        Snap snap = new Snap(0.5);
        assertEquals(new Position(1.5, -0.5), snap.of(world, 1.7, -0.3, 0.1));
        World odd = Edits.with(World.bare(), new Segment(0.123, 0.456, 9, 9));
        assertEquals(new Position(0.123, 0.456), snap.of(odd, 0.2, 0.4, 0.1));
        assertEquals(0.3, new Snap(0.1).of(0.3000000001));
        assertEquals(1.235, new Snap(0).of(1.23456));
    }

    @Test
    void withShiftAWallIsLevelUprightOrDiagonal() {
        Snap snap = new Snap(0.1);
        Position from = new Position(1, 1);
        assertEquals(new Position(4.2, 1), snap.straight(from, 4.22, 1.5));
        assertEquals(new Position(1, -2), snap.straight(from, 0.7, -2.03));
        assertEquals(new Position(3, 3), snap.straight(from, 3.1, 2.9));
        assertEquals(new Position(-1, 3), snap.straight(from, -1.1, 2.9));
    }
}
