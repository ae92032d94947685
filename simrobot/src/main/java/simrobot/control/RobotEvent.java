package simrobot.control;

import java.util.Map;
import simgsm.console.Event;
import simgsm.event.EventLine;
import simgsm.modem.ModemState;
import simgsm.words.HeardWord;
import simrobot.process.BehaviourKind;
import vericommand.Pose;
import vericommand.RobotStatus;

/** An event of one robot, for console, recording, log and window. */
public sealed interface RobotEvent {
    /** The event as the console prints it, with the robot's name as its first field. */
    default Event line(String robot) {
        return Event.from(this, Map.of("robot", robot));
    }

    /** A robot was added; its pose follows. */
    @EventLine("added robot= number=")
    record Added(String number) implements RobotEvent {}

    /** A robot was removed. */
    @EventLine("removed robot= number=")
    record Removed(String number) implements RobotEvent {}

    /** The modem is registered. */
    @EventLine("registered robot= number=")
    record Registered(String number) implements RobotEvent {}

    /** The modem is out of service. @param cause decimal reject cause of TS 24.008, 10.5.3.6; empty if the link is lost */
    @EventLine("unregistered robot= [cause=]")
    record Unregistered(String cause) implements RobotEvent {}

    /** State of a real modem, and answer to {@code modem}: ready, silent, sim-pin, sim-puk, no-sim or no-network. */
    @EventLine("modem robot= state=state.word text=")
    record ModemChanged(ModemState state, String text) implements RobotEvent {}

    /** A call rings. @param from empty if the network does not say */
    @EventLine("ringing robot= from=")
    record CallRinging(String from) implements RobotEvent {}

    /** A call is answered. @param from empty if the network does not say */
    @EventLine("call robot= from=")
    record CallReceived(String from) implements RobotEvent {}

    /** A key is decoded. */
    @EventLine("keys robot= keys=key")
    record KeyReceived(char key) implements RobotEvent {}

    /**
     * An order is accepted, refused or invalid; sent before any motion.
     *
     * @param verdict accepted, refused or invalid
     */
    @EventLine("order robot= text=keys verdict=")
    record OrderVerified(String keys, String verdict) implements RobotEvent {}

    /** An order was answered. @param tone the number of the reply tone */
    @EventLine("outcome robot= tone= text=")
    record OrderAnswered(int tone, String text) implements RobotEvent {}

    /** A reply tone has been sent. */
    @EventLine("tone robot= key=")
    record ToneSent(char key) implements RobotEvent {}

    /** The modem says a reply in words. */
    @EventLine("said robot= text=")
    record Said(String text) implements RobotEvent {}

    /**
     * The ear has compared a word of the caller with the caller's templates.
     *
     * @param ratio distance to the nearest word by that to the second, 0 to 1; over 0.92 the word is refused
     */
    @EventLine("heard robot= word= second= ratio=:2 verdict=")
    record WordHeard(String word, String second, double ratio, boolean isSure) implements RobotEvent {
        static WordHeard of(HeardWord heard) {
            return new WordHeard(heard.word(), heard.second(), heard.ratio(), heard.isSure());
        }

        public String verdict() {
            return isSure ? "sure" : "refused";
        }
    }

    /** A reply SMS was submitted. */
    @EventLine("reply robot= to= text=")
    record ReplySent(String to, String text) implements RobotEvent {}

    /** A reply SMS was refused, or not accepted within 10 minutes. */
    @EventLine("reply-failed robot= to= text=")
    record ReplyFailed(String to, String text) implements RobotEvent {}

    /** A USSD request of the network was answered. */
    @EventLine("ussd robot= text= reply=")
    record UssdAnswered(String text, String reply) implements RobotEvent {}

    /** A short message was received. */
    @EventLine("sms robot= from= text=")
    record MessageReceived(String from, String text) implements RobotEvent {}

    /**
     * An order of a program was received.
     *
     * @param from the owner of the program's key
     */
    @EventLine("submitted robot= from= text=")
    record OrderSubmitted(String from, String text) implements RobotEvent {}

    /** No key was received for 60 s; {@link CallReleased} follows. */
    @EventLine("call-idle robot= seconds=")
    record CallIdle(int seconds) implements RobotEvent {}

    /**
     * A call is cleared; sent before the status that this causes.
     *
     * @param cause of TS 24.008, 10.5.4.11
     */
    @EventLine("released robot= cause=")
    record CallReleased(int cause) implements RobotEvent {}

    /** The robot's status, and answer to {@code status}, {@code power}, {@code motors}. */
    @EventLine("status robot= value=status.text")
    record StatusChanged(RobotStatus status) implements RobotEvent {}

    /** The battery is below 11 V (low), or charged (ok). */
    @EventLine("battery robot= state=")
    record BatteryChanged(boolean isLow) implements RobotEvent {
        public String state() {
            return isLow ? "low" : "ok";
        }
    }

    /** The process, and answer to {@code behaviour}. */
    @EventLine("behaviour robot= value=kind.text")
    record BehaviourChanged(BehaviourKind kind) implements RobotEvent {}

    /**
     * A process has thrown an exception, decided too late, or cannot be compiled.
     *
     * @param line of its source; 0 if unknown
     */
    @EventLine("behaviour-failed robot= name= line= text=")
    record BehaviourFailed(String name, int line, String text) implements RobotEvent {}

    /** A line that a process has printed, or an error of what it asked for. */
    @EventLine("printed robot= name= text=")
    record Printed(String name, String text) implements RobotEvent {}

    /** {@code goto} has reached its place. */
    @EventLine("arrived robot= x=pose.xMeters:4 y=pose.yMeters:4")
    record Arrived(Pose pose) implements RobotEvent {}

    /** Metres, and degrees in [0,360), 0 along +X, anticlockwise positive. */
    @EventLine("pose robot= x=pose.xMeters:4 y=pose.yMeters:4 heading=")
    record PoseReported(Pose pose) implements RobotEvent {
        public String heading() {
            return pose.headingText(2);
        }
    }

    /** The window's user has put the robot at another place; as {@link PoseReported}. */
    @EventLine("placed robot= x=pose.xMeters:4 y=pose.yMeters:4")
    record Placed(Pose pose) implements RobotEvent {}

    /** A real robot's type is not known: no motion. @param type as the robot names it */
    @EventLine("error robot= text=")
    record TypeUnknown(String type) implements RobotEvent {
        public String text() {
            return "robot type " + type + " is not known: no motion; expected --pioneer-params FILE.p";
        }
    }

    /** A text for the operator from a Pioneer program (SIM_MESSAGE). */
    @EventLine("client-message robot= text=")
    record ClientMessage(String text) implements RobotEvent {}
}
