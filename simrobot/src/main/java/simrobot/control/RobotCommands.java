package simrobot.control;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import simgsm.console.CommandException;
import simgsm.console.ConsoleCommand;
import simrobot.camera.Camera;
import simrobot.camera.PictureFile;
import simrobot.process.BehaviourKind;
import simrobot.robot.LaserField;
import simrobot.robot.Pioneer;
import simrobot.robot.Placement;
import simrobot.robot.SimulatedRobot;
import simrobot.route.Destinations;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.Simulation;
import simrobot.simulation.SimulationSnapshot;
import simrobot.world.Goal;
import simrobot.world.Home;
import simrobot.world.Position;
import simrobot.world.World;
import vericommand.Pose;
import vericommand.RobotStatus;

/**
 * The console commands about one robot. Answers are printed on the simulation's thread; files are written on the
 * caller's.
 */
final class RobotCommands {
    private static final double MAX_METERS = 1e6;
    private static final double MAX_DEGREES = 1e6;
    private static final int MAX_NAMES = 20;

    private final RobotConsole console;
    private final TelephoneRobot telephone;
    private final Pioneer robot;

    RobotCommands(RobotConsole console, TelephoneRobot telephone) {
        this.console = console;
        this.telephone = telephone;
        robot = telephone.robot();
    }

    private void answer(RobotEvent event) {
        console.answer(event.line(robot.name()));
    }

    /** A task for the simulation's thread. */
    private interface Act {
        void run() throws CommandException;
    }

    private void onSimulation(Act act) throws CommandException {
        console.onSimulation((Callable<Void>) () -> {
            act.run();
            return null;
        });
    }

    void status() throws CommandException {
        onSimulation(() -> answer(new RobotEvent.StatusChanged(robot.status())));
    }

    void modem() throws CommandException {
        onSimulation(() -> answer(telephone.modemState()));
    }

    void pose() throws CommandException {
        onSimulation(() -> answer(new RobotEvent.PoseReported(robot.pose())));
    }

    void sonar() throws CommandException {
        onSimulation(() -> console.answer(new ConsoleRow.SonarRanges(
                robot.name(),
                Arrays.stream(robot.sonarRangesMillimeters()).boxed().toList())));
    }

    void laser() throws CommandException {
        SimulatedRobot simulated = telephone
                .simulated()
                .orElseThrow(() -> new CommandException("laser: " + robot.name() + " has none that is simulated"));
        onSimulation(() -> console.answer(new ConsoleRow.LaserRanges(
                robot.name(),
                Arrays.stream(simulated.laser().rangesMeters(LaserField.USUAL))
                        .mapToObj(meters -> (int) Math.round(meters * 1000))
                        .toList())));
    }

    private static boolean isOn(ConsoleCommand command) throws CommandException {
        String word = command.words(1, "on or off").get(0);
        if (!word.equals("on") && !word.equals("off")) {
            throw new CommandException(command.name() + ": expected on or off, found " + word);
        }
        return word.equals("on");
    }

    void power(ConsoleCommand command) throws CommandException {
        boolean on = isOn(command);
        onSimulation(() -> setAndAnswer(() -> robot.setPower(on)));
    }

    void motors(ConsoleCommand command) throws CommandException {
        boolean on = isOn(command);
        onSimulation(() -> {
            if (on && !robot.isPowered()) {
                throw new CommandException("motors on: the robot is off, expected power on first");
            }
            if (on && robot.unknownType().isPresent()) {
                throw new CommandException("motors on: robot type "
                        + robot.unknownType().get() + " is not known, expected --pioneer-params FILE.p");
            }
            setAndAnswer(() -> robot.setMotors(on));
        });
    }

    /** Prints an unchanged status; a change is printed by the robot's own event. */
    private void setAndAnswer(Runnable act) {
        RobotStatus before = robot.status();
        act.run();
        if (robot.status() == before) {
            answer(new RobotEvent.StatusChanged(before));
        }
    }

    /** Prints an unchanged or queried process; a change is printed by the robot's own event. */
    void behaviour(ConsoleCommand command) throws CommandException {
        if (command.rest().isEmpty()) {
            onSimulation(() ->
                    answer(new RobotEvent.BehaviourChanged(robot.autonomy().kind())));
            return;
        }
        BehaviourKind kind = kind(command.text());
        onSimulation(() -> begin(command, kind));
    }

    private void begin(ConsoleCommand command, BehaviourKind kind) throws CommandException {
        BehaviourKind before = robot.autonomy().kind();
        if (!robot.autonomy().begin(kind)) {
            throw new CommandException(command.name() + " " + command.rest() + ": not possible in "
                    + robot.status().text());
        }
        if (before.equals(kind)) {
            answer(new RobotEvent.BehaviourChanged(kind));
        }
    }

    /** Drives to a named place or to coordinates. */
    void goTo(ConsoleCommand command) throws CommandException {
        String place = command.text();
        List<String> words = List.of(place.split(" +"));
        boolean isPlace = words.size() == 2
                && words.stream().allMatch(word -> word.matches("[-+]?([0-9]+(\\.[0-9]*)?|\\.[0-9]+)"));
        Position there = isPlace
                ? new Position(
                        number(command.name(), "X", words.get(0), MAX_METERS),
                        number(command.name(), "Y", words.get(1), MAX_METERS))
                : null;
        onSimulation(() -> {
            Simulation owned = console.simRobot().simulation().owned();
            Destinations destinations = owned.destinations();
            BehaviourKind kind = isPlace
                    ? destinations.to(place, there)
                    : destinations.to(owned.world(), place).orElseThrow(() -> noPlace(owned.world(), place));
            begin(command, kind);
        });
    }

    private static CommandException noPlace(World world, String found) {
        String names = Stream.concat(
                        world.items(Goal.class).stream().map(Goal::name),
                        world.items(Home.class).stream().map(Home::name))
                .filter(name -> !name.isBlank())
                .distinct()
                .limit(MAX_NAMES)
                .collect(Collectors.joining(", "));
        return new CommandException("goto: expected X Y in metres" + (names.isEmpty() ? "" : " or one of " + names)
                + ", found " + (found.isEmpty() ? "nothing after it" : found));
    }

    private BehaviourKind kind(String word) throws CommandException {
        try {
            return console.simRobot().behaviours().of(word);
        } catch (IllegalArgumentException e) {
            throw new CommandException("behaviour: " + e.getMessage());
        }
    }

    /** Moves the robot and clears its trail; a move with the mouse keeps the trail. */
    void place(ConsoleCommand command) throws CommandException {
        Pose pose = pose(command.name(), command.words(3, "X Y HEADING"));
        onSimulation(() -> {
            Placement placement = robot.place(pose.xMeters(), pose.yMeters(), Math.toRadians(pose.headingDegrees()));
            if (placement != Placement.DONE) {
                throw new CommandException("place " + command.rest() + ": " + placement.text());
            }
            robot.trail().clear();
            answer(new RobotEvent.PoseReported(robot.pose()));
        });
    }

    void camera(ConsoleCommand command) throws CommandException {
        Path file = file(command, PictureFile::hasKnownEnding, ".png, .jpg or .jpeg");
        SimulationSnapshot scene = console.onSimulation(console.simRobot()::scene);
        RobotSnapshot carrier = scene.robot(robot.name())
                .filter(RobotSnapshot::simulated)
                .orElseThrow(() -> new CommandException("camera: " + robot.name() + " has none that is simulated"));
        try {
            PictureFile.write(new Camera().picture(scene, carrier), file);
        } catch (NoSuchFileException e) {
            throw new CommandException("camera: " + file + " cannot be written, expected a folder that is there");
        } catch (IOException e) {
            throw new CommandException("camera: " + file + " cannot be written: " + e.getMessage());
        }
        console.answer(new ConsoleRow.CameraWritten(robot.name(), file, Camera.WIDTH, Camera.HEIGHT));
    }

    void export(ConsoleCommand command) throws CommandException {
        Path file = file(command, FileExports::hasKnownEnding, ".png, .svg or .csv");
        SimulationSnapshot scene = console.onSimulation(console.simRobot()::scene);
        try {
            console.exports().export(scene, robot.name(), file);
        } catch (IOException e) {
            throw new CommandException("export: " + e.getMessage());
        }
        console.answer(new ConsoleRow.Exported(robot.name(), file));
    }

    private static Path file(ConsoleCommand command, Predicate<Path> isKnown, String endings) throws CommandException {
        String text = command.text();
        try {
            Path file = Path.of(text);
            if (isKnown.test(file)) {
                return file;
            }
        } catch (InvalidPathException e) {
            throw new CommandException(
                    command.name() + ": expected a file name that this system and its locale can have, found " + text);
        }
        throw new CommandException(command.name() + ": expected a file that ends in " + endings + ", found "
                + (text.isEmpty() ? "nothing after it" : text));
    }

    /** Parses three words: metres, metres, degrees. */
    static Pose pose(String command, List<String> words) throws CommandException {
        return new Pose(
                number(command, "X", words.get(0), MAX_METERS),
                number(command, "Y", words.get(1), MAX_METERS),
                number(command, "HEADING", words.get(2), MAX_DEGREES));
    }

    private static double number(String command, String what, String word, double max) throws CommandException {
        if (word.matches("[-+]?([0-9]+(\\.[0-9]*)?|\\.[0-9]+)([eE][-+]?[0-9]{1,3})?")) {
            double number = Double.parseDouble(word);
            if (Math.abs(number) <= max) {
                return number;
            }
        }
        throw new CommandException(command + ": expected a number for " + what + ", found " + word);
    }
}
