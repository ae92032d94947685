package simrobot.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Stream;
import simgsm.console.Arguments;
import simgsm.console.Event;
import simgsm.console.UsageException;
import simrobot.control.ConsoleRow;
import simrobot.control.RobotEvent;
import simrobot.control.SimRobot;
import simrobot.process.BehaviourKind;
import simrobot.process.BehaviourList;
import simrobot.process.Decision;
import simrobot.source.BehaviourFolder;

/** The processes of a command line: {@code --behaviours DIR} and {@code --behaviour NAME}. */
public final class RequestedBehaviours implements AutoCloseable {
    private final BehaviourList list;
    private final Optional<BehaviourFolder> folder;

    private RequestedBehaviours(BehaviourList list, Optional<BehaviourFolder> folder) {
        this.list = list;
        this.folder = folder;
    }

    /**
     * Loads the folder's processes into the list; a run, which takes no orders, needs no numbers that stay.
     *
     * @throws UsageException if the path is no folder
     */
    public static RequestedBehaviours of(Arguments arguments, BehaviourList list) throws UsageException, IOException {
        Optional<Path> place = arguments.path("behaviours");
        if (place.isEmpty()) {
            return new RequestedBehaviours(list, Optional.empty());
        }
        // output of a process must not appear between the console's events or the rows of a table
        if (arguments.has("runs")) {
            System.setOut(System.err);
        } else {
            BehaviourFolder.takePrints();
        }
        try {
            BehaviourFolder folder = new BehaviourFolder(
                    place.get(), list, SimRobotOptions.children(arguments), chosenFiles(arguments, place.get()));
            if (!arguments.has("run")) {
                folder.keepNumbers();
            }
            return new RequestedBehaviours(list, Optional.of(folder));
        } catch (NotDirectoryException e) {
            throw new UsageException("--behaviours: expected a folder, found " + place.get());
        }
    }

    /** A run compiles only the file of its process. */
    private static Predicate<Path> chosenFiles(Arguments arguments, Path folder) {
        String name = arguments.text("behaviour").orElse("");
        return Stream.of(".java", ".py")
                .map(extension -> folder.resolve(name + extension))
                .filter(file -> arguments.has("run") && Files.isRegularFile(file))
                .findFirst()
                .<Predicate<Path>>map(only -> only::equals)
                .orElse(file -> true);
    }

    /** The process that every robot starts with. */
    public BehaviourKind chosen(Arguments arguments) throws UsageException {
        return chosen(arguments, list);
    }

    /**
     * Has the folder's processes decide on this thread, which simulates a run without a clock.
     *
     * @param ended told why a process ends the program, on another thread
     */
    public void callDirectly(Consumer<Decision.Failed> ended) {
        folder.ifPresent(opened -> opened.callDirectly(ended));
    }

    /** Makes the simulation wait for each decision of the folder's processes, so that a loaded machine changes no pose. */
    public void waitForDecisions() {
        folder.ifPresent(BehaviourFolder::waitForDecisions);
    }

    /**
     * Chooses for one of several runs without a clock: adds the loaded processes to the list of its simulation and chooses
     * from that, because it has goals of its own.
     */
    public BehaviourKind chosenForRun(Arguments arguments, BehaviourList ofRun) throws UsageException {
        list.kinds().stream()
                .filter(kind -> !BehaviourKind.BUILT_IN.contains(kind))
                .forEach(ofRun::put);
        list.faults().forEach(ofRun::setFault);
        return chosen(arguments, ofRun);
    }

    private static BehaviourKind chosen(Arguments arguments, BehaviourList from) throws UsageException {
        Optional<String> name = arguments.value("behaviour", text -> text);
        if (name.isEmpty()) {
            return BehaviourKind.NONE;
        }
        for (BehaviourList.Fault fault : from.faults()) {
            if (fault.name().equals(name.get())) {
                throw new UsageException(
                        "--behaviour " + fault.name() + ": line " + fault.line() + ": " + fault.text());
            }
        }
        return arguments.value("behaviour", from::of).orElseThrow();
    }

    /**
     * Reports the status of robots that a process moves from the start, the loaded processes, and changes from now on;
     * robots continue with the new version of a changed process.
     */
    public void start(SimRobot simRobot, Consumer<Event> out) {
        simRobot.simulation()
                .withSimulation(owned -> simRobot.robots().stream()
                        .filter(each -> each.robot().autonomy().isUnfinished())
                        .forEach(each -> out.accept(
                                new RobotEvent.StatusChanged(each.robot().status()).line(each.name()))));
        if (folder.isEmpty()) {
            return;
        }
        Reports reports = new Reports(simRobot, out);
        for (BehaviourKind kind : list.kinds()) {
            if (!BehaviourKind.BUILT_IN.contains(kind)) {
                reports.loaded(kind);
            }
        }
        for (BehaviourList.Fault fault : list.faults()) {
            reports.failed(fault.name(), fault.line(), fault.text());
        }
        folder.get().start(reports);
        Runtime.getRuntime().addShutdownHook(new Thread(folder.get()::close, "end of behaviours"));
    }

    @Override
    public void close() {
        folder.ifPresent(BehaviourFolder::close);
    }

    private record Reports(SimRobot simRobot, Consumer<Event> out) implements BehaviourFolder.Listener {
        @Override
        public void loaded(BehaviourKind kind) {
            out.accept(new ConsoleRow.BehaviourLoaded(kind.text()).line());
            simRobot.simulation()
                    .withSimulation(owned -> simRobot.robots()
                            .forEach(robot -> robot.robot().autonomy().renew(kind)));
        }

        @Override
        public void failed(String name, int line, String text) {
            out.accept(new RobotEvent.BehaviourFailed(name, line, text).line(""));
        }

        @Override
        public void removed(String name) {
            out.accept(new ConsoleRow.BehaviourRemoved(name).line());
        }
    }
}
