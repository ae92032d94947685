package simrobot.control;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import simgsm.console.CommandException;
import simgsm.console.Console;
import simgsm.console.ConsoleCommand;
import simgsm.console.Event;
import simrobot.behaviour.BehaviourKind;
import simrobot.camera.Camera;
import simrobot.camera.PictureFile;
import simrobot.robot.Pioneer;
import simrobot.robot.Placement;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.SimulationSnapshot;
import vericommand.Pose;
import vericommand.RobotStatus;

/** SimRobot's console commands; {@code @NAME} in front says which robot is meant, without it the first. */
public final class RobotConsole implements Console.Commands {
    private static final double MAX_METERS = 1e6;
    private static final double MAX_DEGREES = 1e6;

    private final SimRobot simRobot;
    private final FleetConsole fleet;
    private final FileExports exports;
    private final WorldConsole world;
    private final Consumer<Event> out;
    private final Camera camera = new Camera();

    /**
     * @param fleet makes the robots that {@code add} asks for
     * @param exports writes the files that {@code export} asks for
     * @param worlds reads the files that {@code world} names
     * @param out any thread may call it
     */
    public RobotConsole(SimRobot simRobot, Fleet fleet, FileExports exports, Worlds worlds, Consumer<Event> out) {
        this.simRobot = simRobot;
        this.exports = exports;
        this.fleet = new FleetConsole(simRobot, fleet, out);
        world = new WorldConsole(simRobot, worlds, out);
        this.out = out;
    }

    @Override
    public boolean areAddressed() {
        return true;
    }

    @Override
    public void perform(ConsoleCommand command) throws CommandException {
        if (command.isAddressed()) {
            perform(robot(command.name().substring(1)), command.tail());
        } else if (command.name().equals("world")) {
            world.perform(command);
        } else if (!fleet.performs(command)) {
            perform(first(), command);
        }
    }

    private TelephoneRobot first() throws CommandException {
        return simRobot.robots().stream()
                .findFirst()
                .orElseThrow(() -> new CommandException("there is no robot, expected add NAME=NUMBER first"));
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

    private void perform(TelephoneRobot meant, ConsoleCommand command) throws CommandException {
        Pioneer robot = meant.robot();
        switch (command.name()) {
            case "status" -> {
                command.words(0, "nothing after it");
                onSimulation(() -> tell(robot, new RobotEvent.StatusChanged(robot.status())));
            }
            case "pose" -> {
                command.words(0, "nothing after it");
                onSimulation(() -> tell(robot, new RobotEvent.PoseReported(robot.pose())));
            }
            case "sonar" -> {
                command.words(0, "nothing after it");
                onSimulation(() -> sonar(robot));
            }
            case "power" -> power(robot, isOn(command));
            case "motors" -> motors(robot, isOn(command));
            case "place" -> place(robot, command);
            case "camera" -> camera(meant, command);
            case "behaviour" -> behaviour(meant, command);
            case "export" -> export(meant, command);
            case "remove" -> fleet.remove(meant, command);
            default ->
                throw new CommandException("unknown command "
                        + (command.name().isEmpty() ? "behind @" + meant.name() : command.name())
                        + ", expected status, pose, sonar, camera, power, motors, place, behaviour, export, add, remove, robots,"
                        + " world, wait or quit");
        }
    }

    private static boolean isOn(ConsoleCommand command) throws CommandException {
        String word = command.words(1, "on or off").get(0);
        if (!word.equals("on") && !word.equals("off")) {
            throw new CommandException(command.name() + ": expected on or off, found " + word);
        }
        return word.equals("on");
    }

    /** An event about a robot, as the answer to a command. */
    private void tell(Pioneer robot, RobotEvent event) {
        out.accept(event.line(robot.name()));
    }

    private void sonar(Pioneer robot) {
        String ranges = Arrays.stream(robot.sonarRangesMillimeters())
                .mapToObj(Integer::toString)
                .collect(Collectors.joining(","));
        out.accept(Event.of("sonar").with("robot", robot.name()).with("ranges", ranges));
    }

    private void power(Pioneer robot, boolean on) throws CommandException {
        onSimulation(() -> setAndAnswer(robot, () -> robot.setPower(on)));
    }

    private void motors(Pioneer robot, boolean on) throws CommandException {
        onSimulation(() -> {
            if (on && !robot.isPowered()) {
                throw new CommandException("motors on: the robot is off, expected power on first");
            }
            setAndAnswer(robot, () -> robot.setMotors(on));
        });
    }

    /** A status that changes is printed by the robot's own event; one that stays is printed here. */
    private void setAndAnswer(Pioneer robot, Runnable act) {
        RobotStatus before = robot.status();
        act.run();
        if (robot.status() == before) {
            tell(robot, new RobotEvent.StatusChanged(before));
        }
    }

    /** A process that changes is printed by the robot's own event; one that stays, or is asked for, is printed here. */
    private void behaviour(TelephoneRobot meant, ConsoleCommand command) throws CommandException {
        SimulatedRobot robot = meant.simulated()
                .orElseThrow(
                        () -> new CommandException("behaviour: " + meant.name() + " is a real robot and runs none"));
        if (command.rest().isEmpty()) {
            onSimulation(() ->
                    tell(robot, new RobotEvent.BehaviourChanged(robot.autonomy().kind())));
            return;
        }
        BehaviourKind kind = kind(command.words(1, "a behaviour's name").get(0));
        onSimulation(() -> {
            BehaviourKind before = robot.autonomy().kind();
            if (!robot.autonomy().begin(kind)) {
                throw new CommandException("behaviour " + kind.text() + ": not possible in "
                        + robot.status().text());
            }
            if (before == kind) {
                tell(robot, new RobotEvent.BehaviourChanged(kind));
            }
        });
    }

    private static BehaviourKind kind(String word) throws CommandException {
        try {
            return BehaviourKind.ofText(word);
        } catch (IllegalArgumentException e) {
            throw new CommandException("behaviour: " + e.getMessage());
        }
    }

    private void place(Pioneer robot, ConsoleCommand command) throws CommandException {
        List<String> words = command.words(3, "X Y HEADING");
        Pose pose = pose(command.name(), words);
        onSimulation(() -> {
            Placement placement = robot.place(pose.xMeters(), pose.yMeters(), Math.toRadians(pose.headingDegrees()));
            if (placement != Placement.DONE) {
                throw new CommandException("place " + command.rest() + ": " + placement.text());
            }
            tell(robot, new RobotEvent.PoseReported(robot.pose()));
        });
    }

    /** The picture is drawn and written here, not on the simulation's thread. */
    private void camera(TelephoneRobot robot, ConsoleCommand command) throws CommandException {
        Path file = pictureFile(command);
        AtomicReference<SimulationSnapshot> scene = new AtomicReference<>();
        onSimulation(() -> scene.set(simRobot.scene()));
        RobotSnapshot seer = scene.get()
                .robot(robot.name())
                .filter(RobotSnapshot::simulated)
                .orElseThrow(() -> new CommandException("camera: " + robot.name() + " has none that is simulated"));
        try {
            PictureFile.write(camera.picture(scene.get(), seer), file);
        } catch (NoSuchFileException e) {
            throw new CommandException("camera: " + file + " cannot be written, expected a folder that is there");
        } catch (IOException e) {
            throw new CommandException("camera: " + file + " cannot be written: " + e.getMessage());
        }
        out.accept(Event.of("camera")
                .with("robot", robot.name())
                .with("file", file.toString())
                .with("width", Camera.WIDTH)
                .with("height", Camera.HEIGHT));
    }

    private static Path pictureFile(ConsoleCommand command) throws CommandException {
        String text = command.text();
        try {
            Path file = Path.of(text);
            if (PictureFile.isNamedWell(file)) {
                return file;
            }
        } catch (InvalidPathException e) {
            // said below, as for any other name
        }
        throw new CommandException("camera: expected a file that ends in .png, .jpg or .jpeg, found "
                + (text.isEmpty() ? "nothing after it" : text));
    }

    /** What the file is to hold is made and written here, not on the simulation's thread. */
    private void export(TelephoneRobot robot, ConsoleCommand command) throws CommandException {
        String text = command.text();
        Path file = exportFile(text);
        AtomicReference<SimulationSnapshot> scene = new AtomicReference<>();
        onSimulation(() -> scene.set(simRobot.scene()));
        try {
            exports.export(scene.get(), robot.name(), file);
        } catch (IOException e) {
            throw new CommandException("export: " + e.getMessage());
        }
        out.accept(Event.of("exported").with("robot", robot.name()).with("file", file.toString()));
    }

    private static Path exportFile(String text) throws CommandException {
        try {
            Path file = Path.of(text);
            if (FileExports.hasKnownEnding(file)) {
                return file;
            }
        } catch (InvalidPathException e) {
            // said below, as for any other name
        }
        throw new CommandException("export: expected a file that ends in .png, .svg or .csv, found "
                + (text.isEmpty() ? "nothing after it" : text));
    }

    /** Three words: metres, metres, degrees. */
    static Pose pose(String command, List<String> words) throws CommandException {
        return new Pose(
                number(command, "X", words.get(0), MAX_METERS),
                number(command, "Y", words.get(1), MAX_METERS),
                number(command, "HEADING", words.get(2), MAX_DEGREES));
    }

    private static double number(String command, String what, String word, double most) throws CommandException {
        if (word.matches("[-+]?([0-9]+(\\.[0-9]*)?|\\.[0-9]+)([eE][-+]?[0-9]{1,3})?")) {
            double number = Double.parseDouble(word);
            if (Math.abs(number) <= most) {
                return number;
            }
        }
        throw new CommandException(command + ": expected a number for " + what + ", found " + word);
    }

    /** What a command does on the simulation's thread. */
    private interface Act {
        void run() throws CommandException;
    }

    private void onSimulation(Act act) throws CommandException {
        try {
            CommandException refusal = simRobot.onSimulation(() -> {
                try {
                    act.run();
                    return null;
                } catch (CommandException e) {
                    return e;
                }
            });
            if (refusal != null) {
                throw refusal;
            }
        } catch (IllegalStateException e) {
            throw new CommandException(e.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new CommandException("interrupted");
        }
    }
}
