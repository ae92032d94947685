package simrobot.control;

import simrobot.behaviour.BehaviourKind;
import vericommand.Pose;
import vericommand.Reply;
import vericommand.ReplyTone;
import vericommand.RobotStatus;
import vericommand.Verdict;

/** What happens around one robot, in the order in which it happens, on the simulation's thread. */
public interface ControlListener {
    default void registered(String number) {}

    /** @param cause decimal reject cause of TS 24.008, 10.5.3.6, or empty when the link is lost */
    default void unregistered(String cause) {}

    /** A call has come. @param from empty when the network does not say */
    default void call(String from) {}

    default void key(char key) {}

    /** An order was read and verified; nothing has moved yet. */
    default void order(Verdict verdict) {}

    default void outcome(Reply reply) {}

    /** A tone has left whole. */
    default void toneSent(ReplyTone tone) {}

    default void replySent(String to, String text) {}

    default void message(String from, String text) {}

    /** A call is over. @param cause decimal, TS 24.008, 10.5.4.11 */
    default void released(int cause) {}

    default void status(RobotStatus status) {}

    /** Another autonomous process runs, or none any more. */
    default void behaviour(BehaviourKind kind) {}

    /** Where the robot is after an instruction. */
    default void pose(Pose pose) {}
}
