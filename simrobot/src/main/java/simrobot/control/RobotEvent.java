package simrobot.control;

import java.util.Map;
import simgsm.console.Event;
import simgsm.event.EventLine;
import simgsm.modem.ModemState;
import simrobot.process.BehaviourKind;
import vericommand.Pose;
import vericommand.RobotStatus;

/** An event of one robot, for console, recording, log and window. */
public sealed interface RobotEvent {
    /** The event as the console prints it, with the robot's name as its first field. */
    default Event line(String robot) {
        return Event.from(this, Map.of("robot", robot));
    }

    /** A robot was added to the run. */
    @EventLine("added robot= number=")
    record Added(String number) implements RobotEvent {}

    /** A robot was removed from the run. */
    @EventLine("removed robot= number=")
    record Removed(String number) implements RobotEvent {}

    /** The modem is registered. */
    @EventLine("registered robot= number=")
    record Registered(String number) implements RobotEvent {}

    /** @param cause decimal reject cause of TS 24.008, 10.5.3.6; empty if the link is lost */
    @EventLine("unregistered robot= [cause=]")
    record Unregistered(String cause) implements RobotEvent {}

    /** A real modem's state has changed, or a modem's was queried. */
    @EventLine("modem robot= state=state.word text=")
    record ModemChanged(ModemState state, String text) implements RobotEvent {}

    /** A call rings; {@link CallReceived} follows when it is answered. @param from empty if the network does not say */
    @EventLine("ringing robot= from=")
    record CallRinging(String from) implements RobotEvent {}

    /** A call was answered. @param from empty if the network does not say */
    @EventLine("call robot= from=")
    record CallReceived(String from) implements RobotEvent {}

    /** A key was decided in the received speech. */
    @EventLine("keys robot= keys=key")
    record KeyReceived(char key) implements RobotEvent {}

    /** An order was read and verified, before anything moves. @param verdict accepted, refused or invalid */
    @EventLine("order robot= text=keys verdict=")
    record OrderVerified(String keys, String verdict) implements RobotEvent {}

    /** An order was answered. @param tone the number of the reply tone */
    @EventLine("outcome robot= tone= text=")
    record OrderAnswered(int tone, String text) implements RobotEvent {}

    /** The last sample of a reply tone was sent. */
    @EventLine("tone robot= key=")
    record ToneSent(char key) implements RobotEvent {}

    /** A reply SMS was submitted. */
    @EventLine("reply robot= to= text=")
    record ReplySent(String to, String text) implements RobotEvent {}

    /** A reply SMS was refused for good, or not taken for 10 minutes. */
    @EventLine("reply-failed robot= to= text=")
    record ReplyFailed(String to, String text) implements RobotEvent {}

    /** A question of the network by USSD was answered. */
    @EventLine("ussd robot= text= reply=")
    record UssdAnswered(String text, String reply) implements RobotEvent {}

    /** A short message was received. */
    @EventLine("sms robot= from= text=")
    record MessageReceived(String from, String text) implements RobotEvent {}

    /** The modem clears the call, which had no key for 60 s; {@link CallReleased} follows. */
    @EventLine("call-idle robot= seconds=")
    record CallIdle(int seconds) implements RobotEvent {}

    /** A call was cleared. @param cause of TS 24.008, 10.5.4.11 */
    @EventLine("released robot= cause=")
    record CallReleased(int cause) implements RobotEvent {}

    /** The robot's status has changed, or was queried. */
    @EventLine("status robot= value=status.text")
    record StatusChanged(RobotStatus status) implements RobotEvent {}

    /** The battery has become low, or has been charged. */
    @EventLine("battery robot= state=")
    record BatteryChanged(boolean isLow) implements RobotEvent {
        public String state() {
            return isLow ? "low" : "ok";
        }
    }

    /** The autonomous process has changed, or was queried. */
    @EventLine("behaviour robot= value=kind.text")
    record BehaviourChanged(BehaviourKind kind) implements RobotEvent {}

    /**
     * The autonomous process has thrown something, has not decided in time, or cannot be compiled.
     *
     * @param line of its source; 0 if unknown
     */
    @EventLine("behaviour-failed robot= name= line= text=")
    record BehaviourFailed(String name, int line, String text) implements RobotEvent {}

    /** The robot has come to the place to which a process drove it. */
    @EventLine("arrived robot= x=pose.xMeters:4 y=pose.yMeters:4")
    record Arrived(Pose pose) implements RobotEvent {}

    /** The pose after an instruction, or when queried. */
    @EventLine("pose robot= x=pose.xMeters:4 y=pose.yMeters:4 heading=")
    record PoseReported(Pose pose) implements RobotEvent {
        public String heading() {
            return pose.headingText(2);
        }
    }

    /** A real robot's type is not known, so it is not moved. @param type as the robot names it */
    @EventLine("error robot= text=")
    record TypeUnknown(String type) implements RobotEvent {
        public String text() {
            return "robot type " + type + " is not known: no motion; expected --pioneer-params FILE.p";
        }
    }

    /** A Pioneer program sent a text for the operator. */
    @EventLine("client-message robot= text=")
    record ClientMessage(String text) implements RobotEvent {}
}
