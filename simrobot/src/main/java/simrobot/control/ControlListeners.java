package simrobot.control;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import simrobot.behaviour.BehaviourKind;
import vericommand.Pose;
import vericommand.Reply;
import vericommand.ReplyTone;
import vericommand.RobotStatus;
import vericommand.Verdict;

/** All who want to know what happens around one robot, told in the order in which they came. */
final class ControlListeners implements ControlListener {
    private final List<ControlListener> all = new CopyOnWriteArrayList<>();

    void add(ControlListener listener) {
        all.add(listener);
    }

    private void tell(Consumer<ControlListener> word) {
        all.forEach(word);
    }

    @Override
    public void registered(String number) {
        tell(each -> each.registered(number));
    }

    @Override
    public void unregistered(String cause) {
        tell(each -> each.unregistered(cause));
    }

    @Override
    public void call(String from) {
        tell(each -> each.call(from));
    }

    @Override
    public void key(char key) {
        tell(each -> each.key(key));
    }

    @Override
    public void order(Verdict verdict) {
        tell(each -> each.order(verdict));
    }

    @Override
    public void outcome(Reply reply) {
        tell(each -> each.outcome(reply));
    }

    @Override
    public void toneSent(ReplyTone tone) {
        tell(each -> each.toneSent(tone));
    }

    @Override
    public void replySent(String to, String text) {
        tell(each -> each.replySent(to, text));
    }

    @Override
    public void message(String from, String text) {
        tell(each -> each.message(from, text));
    }

    @Override
    public void released(int cause) {
        tell(each -> each.released(cause));
    }

    @Override
    public void status(RobotStatus status) {
        tell(each -> each.status(status));
    }

    @Override
    public void behaviour(BehaviourKind kind) {
        tell(each -> each.behaviour(kind));
    }

    @Override
    public void pose(Pose pose) {
        tell(each -> each.pose(pose));
    }
}
