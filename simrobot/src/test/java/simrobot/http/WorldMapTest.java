package simrobot.http;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import simrobot.world.Area;
import simrobot.world.Segment;
import simrobot.world.World;

class WorldMapTest {
    private static final World LANES = World.of(
            "two lanes",
            Stream.of(new Area(0, 0, 6, 2, 0), new Area(0, 2, 6, 4, 0))
                    .flatMap(lane -> lane.sides().stream())
                    .toList());

    @Test
    void theMapAroundARobotIsItsLaneWhereverItStandsInIt() {
        assertEquals(new Area(0, 0, 6, 2, 0), WorldMap.around(LANES, 1.2, 0.6));
        assertEquals(new Area(0, 0, 6, 2, 0), WorldMap.around(LANES, 5.5, 1.9));
        assertEquals(new Area(0, 2, 6, 4, 0), WorldMap.around(LANES, 1.2, 2.6));
    }

    @Test
    void whereNoWallIsItReachesToTheGroundsEdge() {
        World slanted = World.of("a slanted wall", List.of(new Segment(2, -1, 4, 1)));
        Area ground = slanted.ground();
        assertEquals(
                new Area(ground.minXMeters(), ground.minYMeters(), 3, ground.maxYMeters(), 0),
                WorldMap.around(slanted, 0, 0));
    }
}
