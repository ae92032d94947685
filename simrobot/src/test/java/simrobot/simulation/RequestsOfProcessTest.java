package simrobot.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simgsm.draw.SvgCanvas;
import simrobot.behaviour.Behaviour;
import simrobot.behaviour.BehaviourAnswer;
import simrobot.behaviour.BehaviourRequest;
import simrobot.behaviour.OdometryPose;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;
import simrobot.drawing.Layers;
import simrobot.drawing.Viewport;
import simrobot.drawing.WorldPainter;
import simrobot.process.BehaviourKind;
import simrobot.process.Decision;
import simrobot.robot.SimulatedRobot;
import simrobot.world.Goal;
import simrobot.world.Home;
import simrobot.world.Position;
import simrobot.world.World;
import simrobot.world.WorldBuilder;

/** A process that drives to places, draws on the floor, and knows the pose by its wheels only. */
class RequestsOfProcessTest {
    private final List<String> ends = new ArrayList<>();

    private SimulatedRobot start(Simulation simulation, Behaviour behaviour) {
        SimulatedRobot robot = simulation.addRobot("robot", new Position(1, 1), Math.PI / 2);
        robot.autonomy().addEndListener((kind, how) -> ends.add(how.toString()));
        robot.autonomy().begin(new BehaviourKind("Mine", around -> senses -> {
            BehaviourAnswer answer = BehaviourAnswer.of(behaviour, senses);
            return answer.isDone()
                    ? new Decision.Done(answer.asked())
                    : new Decision.Go(answer.steering(), answer.asked());
        }));
        return robot;
    }

    private static Simulation withGoals() {
        World world = new WorldBuilder(World.bare(), "goals")
                .add(new Goal("Goal", "Door", new Position(3, 1), 0))
                .add(new Home("Desk", new Position(3, 2), 0, Optional.empty()))
                .build();
        return new Simulation(world, 1);
    }

    @Test
    void itDrivesFromPlaceToPlaceAndKnowsWhenItIsThere() {
        List<Position> reached = new ArrayList<>();
        Simulation simulation = withGoals();
        SimulatedRobot[] robot = new SimulatedRobot[1];
        robot[0] = start(simulation, new Behaviour() {
            @Override
            public Steering decide(Senses senses) {
                if (senses.hasArrived()) {
                    reached.add(new Position(senses.xMeters(), senses.yMeters()));
                }
                return goTo(reached.isEmpty() ? "Door" : "Desk");
            }

            @Override
            public boolean isDone() {
                return reached.size() == 2;
            }
        });
        simulation.run(200);
        assertEquals(
                new Position(3, 1),
                robot[0].autonomy().path().get(robot[0].autonomy().path().size() - 1));
        simulation.run(3000);
        assertEquals(List.of("Done[asked=[DriveTo[place=Desk]]]"), ends);
        assertEquals(3, reached.get(0).xMeters(), 0.05);
        assertEquals(1, reached.get(0).yMeters(), 0.05);
        assertEquals(2, robot[0].yMeters(), 0.1);
    }

    @Test
    void aDriveGoesOnAfterLateDecisionsAndBeginsAnewAfterASecondWithoutRequest() {
        List<Boolean> arrived = new ArrayList<>();
        Simulation simulation = withGoals();
        SimulatedRobot robot = start(simulation, new Behaviour() {
            @Override
            public Steering decide(Senses senses) {
                arrived.add(senses.hasArrived());
                boolean rests = senses.seconds() > 60 && senses.seconds() < 62;
                return arrived.size() % 3 == 0 || rests ? Steering.STOP : goTo("Door");
            }
        });
        simulation.run(6000);
        assertEquals(3, robot.xMeters(), 0.05);
        assertEquals(Set.of(true), Set.copyOf(arrived.subList(arrived.size() - 20, arrived.size())));
        simulation.run(150);
        assertEquals(List.of(), robot.autonomy().path());
        simulation.run(100);
        assertEquals(1, robot.autonomy().path().size());
    }

    @Test
    void anUnknownPlaceEndsItAndTheMessageListsThePlaces() {
        Simulation simulation = withGoals();
        start(simulation, new Behaviour() {
            @Override
            public Steering decide(Senses senses) {
                return goTo("Kitchen");
            }
        });
        simulation.run(10);
        assertEquals(
                List.of("Failed[line=0, text=goTo: expected a goal or home of the world, found Kitchen, asked=[]]"),
                ends);
    }

    @Test
    void odometryBeginsAtTheTruthAndDriftsFromItWithNoise() {
        for (double noise : List.of(0.0, 4.0)) {
            Simulation simulation = new Simulation(World.bare(), 3);
            simulation.setNoise(noise);
            List<OdometryPose> believed = new ArrayList<>();
            SimulatedRobot robot = start(simulation, senses -> {
                believed.add(senses.odometry());
                return new Steering(0.4, 0.4);
            });
            simulation.run(3000);
            assertEquals(new OdometryPose(1, 1, Math.PI / 2), believed.get(0));
            OdometryPose last = believed.get(believed.size() - 1);
            double drift = Math.hypot(last.xMeters() - robot.xMeters(), last.yMeters() - robot.yMeters());
            assertEquals(noise > 0, drift > 0.05, "after 12 m with noise " + noise + " by " + drift);
        }
    }

    @Test
    void itDrawsItsNewest500MarksUntilTheNextProcess() {
        Simulation simulation = new Simulation(World.bare(), 1);
        SimulatedRobot robot = start(simulation, new Behaviour() {
            private int step;

            @Override
            public Steering decide(Senses senses) {
                drawLine(step, 0, ++step, 1);
                drawText(0, 0, "mark " + step);
                return Steering.STOP;
            }
        });
        simulation.run(2500);
        assertEquals(500, robot.autonomy().marks().size());
        assertEquals("mark 251", robot.autonomy().marks().get(499).text());
        assertEquals(1, robot.autonomy().marks().get(0).x());
        SvgCanvas g = new SvgCanvas(ink -> ink.name());
        WorldPainter.robots(g, simulation.snapshot(), new Viewport(0, 0, 40, 600, 400), Layers.ALL, "robot");
        assertTrue(g.elements().contains("mark 251"));
        robot.autonomy().begin(BehaviourKind.WANDER);
        assertEquals(List.of(), robot.autonomy().marks());
    }

    @Test
    void requestsOutsideOfADecisionAndFloodsOfThemAreRefused() {
        Behaviour floods = new Behaviour() {
            @Override
            public Steering decide(Senses senses) {
                IntStream.rangeClosed(0, 1000).forEach(i -> drawText(0, 0, "flood"));
                return Steering.STOP;
            }
        };
        assertEquals(
                "more than 1000 requests in a decision, expected fewer",
                assertThrows(IllegalStateException.class, () -> BehaviourAnswer.of(floods, null))
                        .getMessage());
        assertEquals(
                "expected within decide",
                assertThrows(IllegalStateException.class, () -> floods.play("1"))
                        .getMessage());
        assertThrows(IllegalArgumentException.class, () -> new BehaviourRequest.Sms("5550100", "a".repeat(161)));
        assertThrows(IllegalArgumentException.class, () -> floods.play("Ring"));
        assertThrows(IllegalArgumentException.class, () -> floods.drawLine(0, 0, Double.NaN, 0));
        assertThrows(IllegalArgumentException.class, () -> floods.drawText(0, 0, "a".repeat(61)));
    }

    @Test
    void surplusPrintsAreDroppedAndLeaveRoomForOtherRequests() {
        Behaviour prints = senses -> {
            IntStream.range(0, 1500).forEach(i -> BehaviourAnswer.ask(new BehaviourRequest.Printed("line\n")));
            BehaviourAnswer.ask(new BehaviourRequest.Sms("5550100", "last"));
            return Steering.STOP;
        };
        List<BehaviourRequest> asked = BehaviourAnswer.of(prints, null).asked();
        assertEquals(501, asked.size());
        assertEquals(new BehaviourRequest.Sms("5550100", "last"), asked.get(500));
    }
}
