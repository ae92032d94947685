package simrobot.control;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.SortedMap;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import simgsm.console.CommandException;
import simgsm.console.CommandTable;
import simgsm.console.Console;
import simgsm.console.ConsoleCommand;
import simgsm.console.Event;
import simgsm.console.Program;
import simrobot.process.BehaviourKind;
import simrobot.world.Home;
import simrobot.world.Point;
import simrobot.world.Segment;
import simrobot.world.World;
import vericommand.Pose;

/** SimRobot's console: commands about the run and, optionally prefixed by {@code @NAME}, about one robot. */
public final class RobotConsole implements Console.Commands {
    /** All commands, for the console and for the reference. */
    public static final CommandTable<Request> COMMANDS = new CommandTable<Request>(
                    RobotConsole.class.getResourceAsStream("commands.txt"))
            .add("status", (to, command) -> to.robot().status())
            .add("modem", (to, command) -> to.robot().modem())
            .add("pose", (to, command) -> to.robot().pose())
            .add("sonar", (to, command) -> to.robot().sonar())
            .add("laser", (to, command) -> to.robot().laser())
            .add("camera", (to, command) -> to.robot().camera(command))
            .add("power", (to, command) -> to.robot().power(command))
            .add("motors", (to, command) -> to.robot().motors(command))
            .add("place", (to, command) -> to.robot().place(command))
            .add("behaviour", (to, command) -> to.robot().behaviour(command))
            .add("goto", (to, command) -> to.robot().goTo(command))
            .add("behaviours", (to, command) -> to.console.behaviours())
            .add("export", (to, command) -> to.robot().export(command))
            .add("add", (to, command) -> to.console.add(command))
            .add("speed", (to, command) -> new PaceCommands(to.console).speed(command))
            .add("step", (to, command) -> new PaceCommands(to.console).step(command))
            .add("remove", (to, command) -> to.console.remove(to))
            .add("robots", (to, command) -> to.console.list())
            .add("world", (to, command) -> to.console.world(command));

    /** A command and the robot that it addresses. */
    public static final class Request {
        private final RobotConsole console;
        private final Optional<TelephoneRobot> addressed;

        private Request(RobotConsole console, Optional<TelephoneRobot> addressed) {
            this.console = console;
            this.addressed = addressed;
        }

        private TelephoneRobot telephone() throws CommandException {
            return addressed
                    .or(() -> console.simRobot.robots().stream().findFirst())
                    .orElseThrow(() -> new CommandException("there is no robot, expected add NAME=NUMBER first"));
        }

        private RobotCommands robot() throws CommandException {
            return new RobotCommands(console, telephone());
        }
    }

    /** Reads world files. */
    public interface WorldSource {
        /** @throws IOException when the file cannot be read or holds no world */
        World read(Path file) throws IOException;
    }

    private final SimRobot simRobot;
    private final Fleet fleet;
    private final FileExports exports;
    private final WorldSource worlds;
    private final Consumer<Event> out;

    /** @param out receives the events to print; called on any thread */
    public RobotConsole(SimRobot simRobot, Fleet fleet, FileExports exports, WorldSource worlds, Consumer<Event> out) {
        this.simRobot = simRobot;
        this.fleet = fleet;
        this.exports = exports;
        this.worlds = worlds;
        this.out = out;
    }

    @Override
    public boolean areAddressed() {
        return true;
    }

    @Override
    public void perform(ConsoleCommand command) throws CommandException {
        if (!command.isAddressed()) {
            COMMANDS.perform(new Request(this, Optional.empty()), command);
            return;
        }
        TelephoneRobot robot = robot(command.name().substring(1));
        if (command.rest().isEmpty()) {
            throw new CommandException("unknown command behind @" + robot.name() + ", expected one such as status");
        }
        COMMANDS.perform(new Request(this, Optional.of(robot)), command.tail());
    }

    private TelephoneRobot robot(String name) throws CommandException {
        List<TelephoneRobot> robots = simRobot.robots();
        return robots.stream()
                .filter(robot -> robot.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new CommandException("no robot " + name + ", expected one of "
                        + String.join(
                                ", ", robots.stream().map(TelephoneRobot::name).toList())));
    }

    // ---- for the commands ----------------------------------------------------------------------------------------

    SimRobot simRobot() {
        return simRobot;
    }

    FileExports exports() {
        return exports;
    }

    void answer(Event event) {
        out.accept(event);
    }

    void answer(ConsoleRow row) {
        out.accept(row.line());
    }

    /** Performs a task on the simulation's thread and waits for it, at most 5 s. */
    <T> T onSimulation(Callable<T> act) throws CommandException {
        try {
            return simRobot.onSimulation(act);
        } catch (IllegalStateException e) {
            if (e.getCause() instanceof CommandException refusal) {
                throw refusal;
            }
            throw new CommandException(e.getMessage());
        } catch (InterruptedException e) {
            throw interrupted();
        }
    }

    static CommandException interrupted() {
        Thread.currentThread().interrupt();
        return new CommandException("interrupted");
    }

    // ---- the run -------------------------------------------------------------------------------------------------

    private void list() {
        List<TelephoneRobot> robots = simRobot.robots();
        robots.forEach(robot ->
                answer(new ConsoleRow.RobotRow(robot.name(), robot.number().digits())));
        answer(Event.of("end").with("of", "robots").with("count", robots.size()));
    }

    private void behaviours() {
        List<BehaviourKind> kinds = simRobot.behaviours().kinds();
        SortedMap<Integer, BehaviourKind> numbered = simRobot.behaviours().numbered();
        numbered.forEach((number, kind) -> answer(new ConsoleRow.BehaviourRow(OptionalInt.of(number), kind.text())));
        kinds.stream()
                .filter(kind -> !numbered.containsValue(kind))
                .forEach(kind -> answer(new ConsoleRow.BehaviourRow(OptionalInt.empty(), kind.text())));
        answer(Event.of("end").with("of", "behaviours").with("count", kinds.size()));
    }

    private void add(ConsoleCommand command) throws CommandException {
        List<String> words = command.words();
        if (words.size() != 1 && words.size() != 4) {
            throw new CommandException("add: expected NAME=NUMBER [X Y HEADING], found "
                    + (command.rest().isEmpty() ? "nothing after it" : command.rest()));
        }
        Optional<Pose> place = words.size() == 1
                ? Optional.empty()
                : Optional.of(RobotCommands.pose(command.name(), words.subList(1, 4)));
        try {
            TelephoneRobot added = fleet.add(RobotName.parse(words.get(0)), place);
            answer(new RobotEvent.Added(added.number().digits()).line(added.name()));
            Pose stands = simRobot.onSimulation(() -> added.robot().pose());
            answer(new RobotEvent.PoseReported(stands).line(added.name()));
        } catch (IllegalArgumentException | IllegalStateException | Fleet.RobotRefusal | IOException refusal) {
            throw new CommandException("add: " + refusal.getMessage());
        } catch (InterruptedException e) {
            throw interrupted();
        }
    }

    private void remove(Request request) throws CommandException {
        TelephoneRobot robot = request.telephone();
        try {
            if (fleet.remove(robot.name())) {
                answer(new RobotEvent.Removed(robot.number().digits()).line(robot.name()));
            }
        } catch (IllegalStateException refusal) {
            throw new CommandException("remove: " + refusal.getMessage());
        } catch (InterruptedException e) {
            throw interrupted();
        }
    }

    private void world(ConsoleCommand command) throws CommandException {
        String file = command.text();
        Optional<World> next = file.isEmpty() ? Optional.empty() : Optional.of(read(file));
        World world = onSimulation(() -> {
            try {
                next.ifPresent(simRobot.simulation().owned()::load);
                return simRobot.simulation().owned().world();
            } catch (IllegalArgumentException refusal) {
                throw new CommandException("world: " + refusal.getMessage());
            }
        });
        answer(new ConsoleRow.WorldRow(
                world.name(),
                world.items(Segment.class).size(),
                world.items(Point.class).size(),
                world.items(Home.class).size()));
    }

    private World read(String file) throws CommandException {
        try {
            return worlds.read(Path.of(file));
        } catch (IOException e) {
            throw new CommandException("world: " + Program.describe(e));
        } catch (InvalidPathException e) {
            throw new CommandException(
                    "world: expected a file name that this system and its locale can have, found " + file);
        }
    }
}
