package simrobot.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.world.Position;
import simrobot.world.World;
import vericommand.Instruction;

class TrackLogTest {
    private Simulation simulation;
    private SimulatedRobot robot;
    private TrackLog log;

    @BeforeEach
    void aRobotOnABareFloor() {
        simulation = new Simulation(World.bare(), 1);
        robot = simulation.addRobot("anna", new Position(1, 2), Math.PI / 2);
        log = new TrackLog(simulation, 4000);
        log.follow(robot);
    }

    private List<String> lines() {
        return log.csv("anna").lines().toList();
    }

    @Test
    void aTrackBeginsWithItsHeaderAndWhereTheRobotStands() {
        assertEquals(List.of("time s,x m,y m,heading degrees,status", "0.00,1.0000,2.0000,90.00,Stopped"), lines());
    }

    @Test
    void aWayIsReportedTenTimesASecondFromItsBeginningToItsEnd() {
        simulation.run(500);
        robot.start(new Instruction.Forward(50), ended -> {});
        simulation.run(500);
        List<String> lines = lines();
        assertEquals("4.90,1.0000,2.0000,90.00,Stopped", lines.get(2));
        assertEquals("5.00,1.0000,2.0000,90.00,Moving", lines.get(3));
        assertTrue(lines.get(4).startsWith("5.10,1.0000,2.00"), lines.get(4));
        String last = lines.get(lines.size() - 1);
        assertTrue(last.endsWith(",1.0000,2.5000,90.00,Stopped"), last);
        assertTrue(lines.size() > 20 && lines.size() < 50, lines.size() + " lines");
    }

    @Test
    void whoStandsAddsNothing() {
        simulation.run(10_000);
        assertEquals(2, lines().size());
    }

    @Test
    void theOldestMakeRoom() {
        for (int i = 0; i < 5000; i++) {
            robot.place(i * 0.001, 2, 0);
            simulation.run(10);
        }
        List<String> lines = lines();
        assertTrue(lines.size() <= 4001, lines.size() + " lines");
        assertTrue(lines.get(lines.size() - 1).contains(",4.9990,2.0000,0.00,"), lines.get(lines.size() - 1));
    }

    @Test
    void aRobotThatIsNotThereHasNoTrack() {
        assertEquals("time s,x m,y m,heading degrees,status\n", log.csv("nobody"));
        log.forget(robot);
        assertEquals(1, lines().size());
    }
}
