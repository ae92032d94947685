package simrobot.control;

import java.util.Arrays;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import simgsm.console.Event;
import simrobot.behaviour.BehaviourKind;
import simrobot.camera.Camera;
import vericommand.Pose;
import vericommand.Reply;
import vericommand.ReplyTone;
import vericommand.RobotStatus;
import vericommand.Verdict;

/** What happens around one robot, as lines of the headless console. */
public final class RobotEventPrinter implements ControlListener {
    private final String robot;
    private final Consumer<Event> out;

    /** @param out any thread may call it */
    public RobotEventPrinter(String robot, Consumer<Event> out) {
        this.robot = robot;
        this.out = out;
    }

    private Event event(String name) {
        return Event.of(name).with("robot", robot);
    }

    @Override
    public void registered(String number) {
        out.accept(event("registered").with("number", number));
    }

    @Override
    public void unregistered(String cause) {
        Event event = event("unregistered");
        out.accept(cause.isEmpty() ? event : event.with("cause", cause));
    }

    @Override
    public void call(String from) {
        out.accept(event("call").with("from", from));
    }

    @Override
    public void key(char key) {
        out.accept(event("keys").with("keys", key));
    }

    @Override
    public void order(Verdict verdict) {
        out.accept(event("order").with("text", verdict.keys()).with("verdict", verdict.word()));
    }

    @Override
    public void outcome(Reply reply) {
        out.accept(event("outcome").with("tone", reply.tone().number()).with("text", reply.text()));
    }

    @Override
    public void toneSent(ReplyTone tone) {
        out.accept(event("tone").with("key", tone.key()));
    }

    @Override
    public void replySent(String to, String text) {
        out.accept(event("reply").with("to", to).with("text", text));
    }

    @Override
    public void message(String from, String text) {
        out.accept(event("sms").with("from", from).with("text", text));
    }

    @Override
    public void released(int cause) {
        out.accept(event("released").with("cause", cause));
    }

    @Override
    public void status(RobotStatus status) {
        out.accept(event("status").with("value", status.text()));
    }

    @Override
    public void behaviour(BehaviourKind kind) {
        out.accept(event("behaviour").with("value", kind.text()));
    }

    @Override
    public void pose(Pose pose) {
        out.accept(
                event("pose").with("x", pose.xText(4)).with("y", pose.yText(4)).with("heading", pose.headingText(2)));
    }

    /** A picture has been written. */
    void camera(String file) {
        out.accept(
                event("camera").with("file", file).with("width", Camera.WIDTH).with("height", Camera.HEIGHT));
    }

    void sonar(int[] rangesMillimeters) {
        String ranges =
                Arrays.stream(rangesMillimeters).mapToObj(Integer::toString).collect(Collectors.joining(","));
        out.accept(event("sonar").with("ranges", ranges));
    }

    void exported(String file) {
        out.accept(event("exported").with("file", file));
    }
}
