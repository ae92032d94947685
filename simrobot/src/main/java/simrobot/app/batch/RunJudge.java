package simrobot.app.batch;

import java.util.List;
import java.util.Optional;
import simgsm.file.CsvLine;
import simrobot.control.TrackSeries;
import simrobot.process.BehaviourKind;
import simrobot.process.Decision;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import vericommand.RobotStatus;

/** Judges how the robots of a run end. */
final class RunJudge {
    static final String HEADER = "seed,state,robots,done,seconds,meters,collisions,text";

    private final Simulation simulation;
    private final Optional<RunGoal> goal;
    private final List<Judged> robots;
    private long collisions;

    /** @param goal if present, a robot is done when it comes within 0.3 m of it */
    RunJudge(Simulation simulation, BehaviourKind kind, Optional<RunGoal> goal) {
        this.simulation = simulation;
        this.goal = goal;
        robots = simulation.robots().stream()
                .map(robot -> new Judged(robot, kind))
                .toList();
        simulation.addStepListener(time -> robots.forEach(robot -> robot.stepped(time)));
    }

    /** A robot in a run. */
    private final class Judged {
        private final SimulatedRobot robot;
        private final BehaviourKind kind;
        private double x;
        private double y;
        private double meters;
        /** True once the robot has been farther than 0.3 m from its goal. */
        private boolean isAway;
        /** Null until the robot has ended. */
        private RunOutcome outcome;

        Judged(SimulatedRobot robot, BehaviourKind kind) {
            this.robot = robot;
            this.kind = kind;
            x = robot.xMeters();
            y = robot.yMeters();
            robot.autonomy().addEndListener((ended, how) -> ended(how));
            robot.addStatusListener(status -> collisions += status == RobotStatus.COLLISION ? 1 : 0);
        }

        private void stepped(long timeNanos) {
            if (outcome != null) {
                return;
            }
            if (timeNanos % TrackSeries.PERIOD_NANOS == 0) {
                travel();
            }
            if (goal.isPresent()) {
                boolean isReached = goal.get().isReachedBy(robot);
                if (isReached && isAway) {
                    end(RunOutcome.State.DONE, "");
                    robot.autonomy().end();
                }
                isAway |= !isReached;
            }
        }

        private void travel() {
            meters += Math.hypot(robot.xMeters() - x, robot.yMeters() - y);
            x = robot.xMeters();
            y = robot.yMeters();
        }

        private void ended(Decision.End how) {
            if (how instanceof Decision.Failed failed) {
                end(RunOutcome.State.FAILED, failed.where() + failed.text());
            } else if (how instanceof Decision.GivenUp givenUp) {
                end(RunOutcome.State.FAILED, givenUp.text());
            } else if (how instanceof Decision.Collided) {
                end(RunOutcome.State.COLLISION, "in collision for 3 s");
            } else if (how instanceof Decision.Replaced) {
                end(RunOutcome.State.FAILED, "ended: " + robot.status().text());
            } else if (goal.isPresent() && !goal.get().isReachedBy(robot)) {
                end(RunOutcome.State.FAILED, "says that it is done, " + distance());
            } else {
                end(RunOutcome.State.DONE, "");
            }
        }

        private String distance() {
            return goal.map(place -> RunOutcome.threeDecimals(place.metersFrom(robot)) + " m from " + place.name())
                    .orElse("not done");
        }

        private void end(RunOutcome.State state, String text) {
            if (outcome == null) {
                travel();
                outcome = new RunOutcome(robot.name(), kind.text(), state, simulation.timeNanos() * 1e-9, meters, text);
            }
        }
    }

    /** Starts the processes. */
    void begin() {
        for (Judged judged : robots) {
            if (!judged.robot.autonomy().begin(judged.kind)) {
                judged.end(
                        RunOutcome.State.FAILED,
                        "not started: " + judged.robot.status().text());
            }
        }
    }

    boolean isAllDone() {
        return outcomes().stream().allMatch(outcome -> outcome.state() == RunOutcome.State.DONE);
    }

    boolean isDecided() {
        return robots.stream().allMatch(judged -> judged.outcome != null);
    }

    /** The run is over for all robots that have not ended. @param text the reason; empty for the time */
    void end(RunOutcome.State state, String text) {
        for (Judged judged : robots) {
            judged.end(state, text.isEmpty() ? judged.distance() : text);
        }
    }

    List<RunOutcome> outcomes() {
        return robots.stream().map(judged -> judged.outcome).toList();
    }

    /** A line of CSV: state and text of the first robot that is not done, the longest time, metres of all robots together. */
    String row(long seed) {
        List<RunOutcome> outcomes = outcomes();
        List<RunOutcome> others = outcomes.stream()
                .filter(each -> each.state() != RunOutcome.State.DONE)
                .toList();
        RunOutcome first = others.isEmpty() ? outcomes.get(0) : others.get(0);
        return seed + ","
                + CsvLine.of(List.of(
                        first.state().word(),
                        "" + outcomes.size(),
                        "" + (outcomes.size() - others.size()),
                        RunOutcome.threeDecimals(outcomes.stream()
                                .mapToDouble(RunOutcome::seconds)
                                .max()
                                .orElse(0)),
                        RunOutcome.threeDecimals(outcomes.stream()
                                .mapToDouble(RunOutcome::meters)
                                .sum()),
                        "" + collisions,
                        first.text()));
    }
}
