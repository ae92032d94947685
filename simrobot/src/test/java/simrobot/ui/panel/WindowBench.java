package simrobot.ui.panel;

import java.awt.Component;
import java.awt.Container;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.ToIntFunction;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import simgsm.air.Msisdn;
import simgsm.draw.Ink;
import simgsm.scope.ToneTrace;
import simgsm.sim.PinLock;
import simgsm.speech.SpeechCodec;
import simgsm.station.StationSnapshot;
import simgsm.station.call.MobileCallTable.MobileCallState;
import simgsm.tone.ToneExperiment;
import simgsm.ui.ComponentNames;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simrobot.control.LoggedEvent;
import simrobot.process.BehaviourKind;
import simrobot.robot.Placement;
import simrobot.simulation.Simulation;
import simrobot.ui.OpenPort;
import simrobot.ui.OperatorActions;
import simrobot.ui.TelephoneSnapshot;
import simrobot.ui.Timeline;
import simrobot.ui.WindowSnapshot;
import simrobot.ui.floor.WorldView;
import simrobot.world.MapWriter;
import simrobot.world.World;
import simrobot.world.WorldReader;
import vericommand.LocalizedText;
import vericommand.OrderCourse;
import vericommand.OrderSource;
import vericommand.Pose;
import vericommand.VeriCommandSnapshot;

/** A window without a frame over a simulation that is moved by hand; it notes what its operator did. */
public final class WindowBench implements OperatorActions {
    public final Simulation simulation;
    public final SimRobotPanel panel;
    public final List<String> acts = new ArrayList<>();
    List<TelephoneSnapshot> lines = List.of();
    public boolean paused;
    String notice = "";
    List<OpenPort> ports = List.of();
    public List<LoggedEvent> events = List.of();
    public Optional<Timeline> timeline = Optional.empty();
    boolean worldChanged;
    public Optional<Path> recording = Optional.empty();
    Optional<String> refusal = Optional.empty();

    public WindowBench(String worldFile, Locale language, String... robots) throws Exception {
        simulation = new Simulation(world(worldFile), 1);
        for (String robot : robots) {
            simulation.addRobot(robot);
        }
        panel = new SimRobotPanel(language, picture(), this);
        resize(1100, 800);
    }

    public static World world(String file) throws Exception {
        return WorldReader.read(Path.of("..", "worlds", file));
    }

    WindowSnapshot picture() {
        return new WindowSnapshot(
                simulation.snapshot(),
                lines,
                1,
                paused,
                Path.of("..", "worlds", simulation.world().name()),
                notice,
                ports,
                events,
                timeline,
                recording,
                worldChanged);
    }

    /** Shows the simulation as it is now. */
    public WindowBench show() {
        panel.show(picture());
        return this;
    }

    public WindowBench resize(int width, int height) {
        panel.setSize(width, height);
        layout(panel);
        layout(panel);
        for (var listener : component("world").getComponentListeners()) {
            listener.componentResized(null);
        }
        return this;
    }

    static void layout(Container container) {
        container.doLayout();
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                layout(inner);
            }
        }
    }

    public Component component(String name) {
        return ComponentNames.find(panel, name).orElseThrow(() -> new AssertionError("no component " + name));
    }

    public String spoken(String name) {
        return component(name).getAccessibleContext().getAccessibleName();
    }

    /** Answers that came from this thread are on the screen afterwards. */
    public WindowBench settle() throws Exception {
        SwingUtilities.invokeAndWait(() -> {});
        return show();
    }

    void type(String name, String text) {
        ((JTextField) component(name)).setText(text);
    }

    public void click(String name) {
        ((AbstractButton) component(name)).doClick(0);
    }

    /** Performs a command that only the menu has; true if it is a switch that is on then. */
    public boolean command(String id) {
        UserAction action =
                actions(panel).filter(each -> each.id().equals(id)).findFirst().orElseThrow();
        action.actionPerformed(null);
        return Boolean.TRUE.equals(action.getValue(UserAction.SELECTED_KEY));
    }

    private static Stream<UserAction> actions(Container parent) {
        Stream<UserAction> own =
                parent instanceof JComponent bound && bound.getActionMap().keys() != null
                        ? Stream.of(bound.getActionMap().keys())
                                .map(bound.getActionMap()::get)
                                .filter(UserAction.class::isInstance)
                                .map(UserAction.class::cast)
                        : Stream.empty();
        return Stream.concat(
                own,
                Stream.of(parent.getComponents())
                        .filter(Container.class::isInstance)
                        .flatMap(child -> actions((Container) child)));
    }

    public WorldView floor() {
        return (WorldView) component("world");
    }

    public static BufferedImage painted(Component component, double scale) {
        BufferedImage image = new BufferedImage(
                (int) Math.ceil(component.getWidth() * scale),
                (int) Math.ceil(component.getHeight() * scale),
                BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.scale(scale, scale);
        component.paint(g);
        g.dispose();
        return image;
    }

    /** How many pixels are nearly of that colour. */
    public static int count(BufferedImage image, Ink ink) {
        int wanted = Theme.color(ink).getRGB();
        int found = 0;
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                found += near(image.getRGB(x, y), wanted) ? 1 : 0;
            }
        }
        return found;
    }

    private static boolean near(int a, int b) {
        ToIntFunction<Integer> difference = shift -> Math.abs((a >> shift & 0xFF) - (b >> shift & 0xFF));
        return difference.applyAsInt(16) < 6 && difference.applyAsInt(8) < 6 && difference.applyAsInt(0) < 6;
    }

    // ---- a telephone
    // -------------------------------------------------------------------------------------------------

    static TelephoneSnapshot line(
            String robot, boolean registered, boolean inCall, VeriCommandSnapshot orders, String tones) {
        return line(robot, registered, inCall, orders, tones, Optional.empty());
    }

    static TelephoneSnapshot line(
            String robot,
            boolean registered,
            boolean inCall,
            VeriCommandSnapshot orders,
            String tones,
            Optional<SpeechCodec.Kind> heardCodec) {
        StationSnapshot modem = new StationSnapshot(
                true,
                registered,
                registered,
                Optional.empty(),
                false,
                "SimGSM",
                inCall ? MobileCallState.ACTIVE : MobileCallState.NULL,
                inCall ? Optional.of(new Msisdn("5550100")) : Optional.empty(),
                Optional.of(SpeechCodec.Kind.A_LAW),
                heardCodec,
                Optional.empty(),
                PinLock.none().status());
        return new TelephoneSnapshot(robot, "5550200", modem, ToneTrace.EMPTY, orders, tones, "", false);
    }

    static VeriCommandSnapshot orders(String keys, String words, String verdict, String text, int fault) {
        return new VeriCommandSnapshot(
                "5550100",
                OrderSource.CALL,
                true,
                false,
                keys,
                said(words),
                verdict,
                said(text),
                OrderCourse.NONE,
                fault,
                List.of());
    }

    /** A text that is the same in both languages. */
    static LocalizedText said(String text) {
        return new LocalizedText(text, text);
    }

    static VeriCommandSnapshot noOrders() {
        return new VeriCommandSnapshot(
                "", OrderSource.CALL, false, false, "", said(""), "", said(""), OrderCourse.NONE, 0, List.of());
    }

    // ---- what the operator did
    // -----------------------------------------------------------------------------------------

    @Override
    public void setPower(String robot, boolean on) {
        acts.add("power " + robot + " " + on);
        simulation.robot(robot).orElseThrow().setPower(on);
    }

    @Override
    public void setMotors(String robot, boolean on) {
        acts.add("motors " + robot + " " + on);
        simulation.robot(robot).orElseThrow().setMotors(on);
    }

    @Override
    public void place(String robot, double xMeters, double yMeters, double headingRadians, Consumer<Placement> answer) {
        acts.add("place " + robot);
        answer.accept(simulation.robot(robot).orElseThrow().place(xMeters, yMeters, headingRadians));
    }

    @Override
    public void tryOut(String robot, ToneExperiment experiment) {
        acts.add("try " + robot + " " + experiment.snrDecibels() + " dB " + experiment.shiftPercent() + " %");
    }

    @Override
    public void addRobot(String name, String number, Optional<Pose> place, Consumer<Optional<String>> answer) {
        acts.add("add " + name + " " + number
                + place.map(pose -> " at " + pose.xText(2) + " " + pose.yText(2))
                        .orElse(""));
        if (refusal.isEmpty()) {
            simulation.addRobot(name);
        }
        answer.accept(refusal);
    }

    @Override
    public void removeRobot(String robot) {
        acts.add("remove " + robot);
        simulation.removeRobot(simulation.robot(robot).orElseThrow());
    }

    @Override
    public void brake(String robot) {
        acts.add("brake " + robot);
    }

    @Override
    public void setBehaviour(String robot, BehaviourKind kind) {
        acts.add("behaviour " + robot + " " + kind);
        simulation.robot(robot).orElseThrow().autonomy().begin(kind);
    }

    @Override
    public void watch(String robot) {
        acts.add("watch " + robot);
    }

    @Override
    public void setSpeed(double simulatedSecondsPerSecond) {
        acts.add("speed " + simulatedSecondsPerSecond);
    }

    @Override
    public void setPaused(boolean pause) {
        acts.add("pause " + pause);
        paused = pause;
    }

    @Override
    public void stepOnce() {
        acts.add("step");
        simulation.step();
    }

    @Override
    public void apply(World world, Path file, Consumer<Optional<String>> answer) {
        acts.add("apply " + file.getFileName());
        simulation.change(world);
        answer.accept(Optional.empty());
    }

    @Override
    public void save(World world, Path file, Consumer<Optional<String>> answer) {
        acts.add("save " + file.getFileName());
        if (file.startsWith(Path.of("..", "worlds"))) {
            answer.accept(Optional.of("the suite's worlds are only read"));
            return;
        }
        try {
            MapWriter.save(world, file);
            answer.accept(Optional.empty());
        } catch (IOException refusal) {
            answer.accept(Optional.of(refusal.getMessage()));
        }
    }

    @Override
    public void keep(World draft, Path file) {
        save(draft, file, refusal -> {});
    }

    @Override
    public void dropKept(Path file) {
        try {
            Files.deleteIfExists(file);
        } catch (IOException refusal) {
            throw new UncheckedIOException(refusal);
        }
    }

    @Override
    public void export(String robot, Path file, Consumer<Optional<String>> answer) {
        acts.add("export " + robot + " " + file.getFileName());
        answer.accept(Optional.empty());
    }

    @Override
    public void seek(long nanos) {
        acts.add("seek " + nanos);
    }

    @Override
    public void record(Optional<Path> file) {
        acts.add("record " + file.isPresent());
        recording = file;
    }

    @Override
    public void tell(String message) {
        notice = message;
    }

    @Override
    public void load(Path worldFile) {
        acts.add("load " + worldFile.getFileName());
    }
}
