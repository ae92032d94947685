package simrobot.control;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.console.CommandException;
import simgsm.console.ConsoleCommand;
import simgsm.console.Event;
import simgsm.console.Program;
import simrobot.simulation.Simulation;
import simrobot.world.World;

/** The console command about the world: {@code world} tells which it is, {@code world FILE} loads one, the same one, too. */
final class WorldConsole {
    private final SimRobot simRobot;
    private final Worlds worlds;
    private final Consumer<Event> out;

    WorldConsole(SimRobot simRobot, Worlds worlds, Consumer<Event> out) {
        this.simRobot = simRobot;
        this.worlds = worlds;
        this.out = out;
    }

    void perform(ConsoleCommand command) throws CommandException {
        String file = command.text();
        Optional<World> next = file.isEmpty() ? Optional.empty() : Optional.of(read(file));
        try {
            World world = simRobot.onSimulation(() -> {
                Simulation simulation = simRobot.simulation().owned();
                next.ifPresent(simulation::load);
                return simulation.world();
            });
            out.accept(about(world));
        } catch (IllegalStateException e) {
            // what the simulation refused, in its own words
            throw new CommandException("world: "
                    + (e.getCause() instanceof IllegalArgumentException refusal
                            ? refusal.getMessage()
                            : e.getMessage()));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new CommandException("interrupted");
        }
    }

    private World read(String file) throws CommandException {
        try {
            return worlds.read(Path.of(file));
        } catch (IOException e) {
            throw new CommandException("world: " + Program.describe(e));
        } catch (InvalidPathException e) {
            throw new CommandException("world: expected a world file, found " + file);
        }
    }

    private static Event about(World world) {
        return Event.of("world")
                .with("name", world.name())
                .with("lines", world.segments().size())
                .with("points", world.points().size())
                .with("homes", world.homes().size());
    }
}
