package simrobot.control;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.console.CommandException;
import simgsm.console.ConsoleCommand;
import simgsm.console.Event;
import vericommand.Pose;

/** The console commands about which robots there are: {@code robots}, {@code add}, and {@code remove} of one. */
final class FleetConsole {
    private final SimRobot simRobot;
    private final Fleet fleet;
    private final Consumer<Event> out;

    FleetConsole(SimRobot simRobot, Fleet fleet, Consumer<Event> out) {
        this.simRobot = simRobot;
        this.fleet = fleet;
        this.out = out;
    }

    /** @return false when the command is none of these */
    boolean performs(ConsoleCommand command) throws CommandException {
        switch (command.name()) {
            case "robots" -> list(command);
            case "add" -> add(command);
            default -> {
                return false;
            }
        }
        return true;
    }

    private void list(ConsoleCommand command) throws CommandException {
        command.words(0, "nothing after it");
        List<TelephoneRobot> robots = simRobot.robots();
        robots.forEach(robot -> out.accept(Event.of("robot")
                .with("robot", robot.name())
                .with("number", robot.number().digits())));
        out.accept(Event.of("end").with("of", "robots").with("count", robots.size()));
    }

    private void add(ConsoleCommand command) throws CommandException {
        List<String> words = command.words();
        if (words.size() != 1 && words.size() != 4) {
            throw new CommandException("add: expected NAME=NUMBER [X Y HEADING], found "
                    + (command.rest().isEmpty() ? "nothing after it" : command.rest()));
        }
        Optional<Pose> place = words.size() == 1
                ? Optional.empty()
                : Optional.of(RobotConsole.pose(command.name(), words.subList(1, 4)));
        try {
            TelephoneRobot added = fleet.add(RobotName.parse(words.get(0)), place);
            out.accept(new RobotEvent.Added(added.number().digits()).line(added.name()));
            Pose stands = simRobot.onSimulation(() -> added.robot().pose());
            out.accept(new RobotEvent.PoseReported(stands).line(added.name()));
        } catch (IllegalArgumentException | IllegalStateException | Fleet.Refusal | IOException refusal) {
            throw new CommandException("add: " + refusal.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new CommandException("interrupted");
        }
    }

    void remove(TelephoneRobot robot, ConsoleCommand command) throws CommandException {
        command.words(0, "nothing after it");
        try {
            if (fleet.remove(robot.name())) {
                out.accept(new RobotEvent.Removed(robot.number().digits()).line(robot.name()));
            }
        } catch (IllegalStateException refusal) {
            throw new CommandException("remove: " + refusal.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new CommandException("interrupted");
        }
    }
}
