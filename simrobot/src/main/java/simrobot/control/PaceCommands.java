package simrobot.control;

import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.regex.Pattern;
import simgsm.console.CommandException;
import simgsm.console.ConsoleCommand;
import simrobot.simulation.SimulationThread;

/** Commands for the simulation's pace. */
final class PaceCommands {
    static final double MIN_SPEED = 0.001;
    static final double MAX_SPEED = 1000;
    /** 100 s of simulated time. */
    static final int MAX_STEPS = 10_000;

    /** Excludes Java's suffixes and hexadecimal digits. */
    private static final Pattern DECIMAL = Pattern.compile("[+-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]+)?");

    private final RobotConsole console;
    private final SimulationThread simulation;

    PaceCommands(RobotConsole console) {
        this.console = console;
        simulation = console.simRobot().simulation();
    }

    /** {@code speed N}; 0 pauses. */
    void speed(ConsoleCommand command) throws CommandException {
        double speed = number(command.words(1, "speed N").get(0));
        simulation.setPaused(speed == 0);
        if (speed > 0) {
            simulation.setSpeed(speed);
        }
        console.answer(console.onSimulation(
                () -> new ConsoleRow.Speed(simulation.isPaused() ? "0" : text(simulation.speed()))));
    }

    private static double number(String word) throws CommandException {
        double speed = DECIMAL.matcher(word).matches() ? Double.parseDouble(word) : Double.NaN;
        if (speed == 0 || speed >= MIN_SPEED && speed <= MAX_SPEED) {
            return speed;
        }
        throw new CommandException("speed: expected 0, or " + MIN_SPEED + " to " + text(MAX_SPEED)
                + " simulated seconds per second, found " + word);
    }

    private static String text(double number) {
        return number == Math.rint(number) ? Long.toString((long) number) : Double.toString(number);
    }

    /** {@code step [N]}, for a paused simulation. */
    void step(ConsoleCommand command) throws CommandException {
        List<String> words = command.words();
        if (words.size() > 1) {
            throw new CommandException("step: expected [N], found " + command.rest());
        }
        int count = words.isEmpty() ? 1 : count(words.get(0));
        if (!console.onSimulation(simulation::isPaused)) {
            throw new CommandException("step: the simulation runs, expected speed 0 before");
        }
        try {
            simulation.steps(count).get();
        } catch (InterruptedException e) {
            throw RobotConsole.interrupted();
        } catch (ExecutionException | CancellationException ended) {
            throw new CommandException("step: the simulation has ended");
        }
        console.answer(console.onSimulation(
                () -> new ConsoleRow.Steps(count, simulation.owned().timeNanos() * 1e-9)));
    }

    private static int count(String word) throws CommandException {
        if (word.matches("[0-9]{1,5}")) {
            int count = Integer.parseInt(word);
            if (count >= 1 && count <= MAX_STEPS) {
                return count;
            }
        }
        throw new CommandException("step: expected 1 to " + MAX_STEPS + " steps of 10 ms, found " + word);
    }
}
