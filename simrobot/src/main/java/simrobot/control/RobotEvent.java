package simrobot.control;

import java.util.Map;
import java.util.Optional;
import simgsm.console.Event;
import simgsm.modem.ModemState;
import simrobot.process.BehaviourKind;
import vericommand.Pose;
import vericommand.RobotStatus;

/** An event of one robot, for console, recording, log and window. */
public sealed interface RobotEvent {
    /** The event as the console prints it, with the robot's name as its first field. */
    Event line(String robot);

    /** A robot was added to the run. */
    record Added(String number) implements RobotEvent {
        @Override
        public Event line(String robot) {
            return about(robot, "added").with("number", number);
        }
    }

    /** A robot was removed from the run. */
    record Removed(String number) implements RobotEvent {
        @Override
        public Event line(String robot) {
            return about(robot, "removed").with("number", number);
        }
    }

    /** The modem is registered. */
    record Registered(String number) implements RobotEvent {
        @Override
        public Event line(String robot) {
            return about(robot, "registered").with("number", number);
        }
    }

    /** @param cause decimal reject cause of TS 24.008, 10.5.3.6; empty if the link is lost */
    record Unregistered(String cause) implements RobotEvent {
        @Override
        public Event line(String robot) {
            Event event = about(robot, "unregistered");
            return cause.isEmpty() ? event : event.with("cause", cause);
        }
    }

    /** A real modem's state has changed, or a modem's was queried. */
    record ModemChanged(ModemState state, String text) implements RobotEvent {
        public String word() {
            return state.word();
        }

        @Override
        public Event line(String robot) {
            return about(robot, "modem").with("state", word()).with("text", text);
        }
    }

    /** A call rings; {@link CallReceived} follows when it is answered. @param from empty if the network does not say */
    record CallRinging(String from) implements RobotEvent {
        @Override
        public Event line(String robot) {
            return about(robot, "ringing").with("from", from);
        }
    }

    /** A call was answered. @param from empty if the network does not say */
    record CallReceived(String from) implements RobotEvent {
        @Override
        public Event line(String robot) {
            return about(robot, "call").with("from", from);
        }
    }

    /** A key was decided in the received speech. */
    record KeyReceived(char key) implements RobotEvent {
        @Override
        public Event line(String robot) {
            return about(robot, "keys").with("keys", key);
        }
    }

    /** An order was read and verified, before anything moves. @param verdict accepted, refused or invalid */
    record OrderVerified(String keys, String verdict) implements RobotEvent {
        @Override
        public Event line(String robot) {
            return about(robot, "order").with("text", keys).with("verdict", verdict);
        }
    }

    /** An order was answered. @param tone the number of the reply tone */
    record OrderAnswered(int tone, String text) implements RobotEvent {
        @Override
        public Event line(String robot) {
            return about(robot, "outcome").with("tone", tone).with("text", text);
        }
    }

    /** The last sample of a reply tone was sent. */
    record ToneSent(char key) implements RobotEvent {
        @Override
        public Event line(String robot) {
            return about(robot, "tone").with("key", key);
        }
    }

    /** A reply SMS was submitted. */
    record ReplySent(String to, String text) implements RobotEvent {
        @Override
        public Event line(String robot) {
            return about(robot, "reply").with("to", to).with("text", text);
        }
    }

    /** A reply SMS was refused for good, or not taken for 10 minutes. */
    record ReplyFailed(String to, String text) implements RobotEvent {
        @Override
        public Event line(String robot) {
            return about(robot, "reply-failed").with("to", to).with("text", text);
        }
    }

    /** A question of the network by USSD was answered. */
    record UssdAnswered(String text, String reply) implements RobotEvent {
        @Override
        public Event line(String robot) {
            return about(robot, "ussd").with("text", text).with("reply", reply);
        }
    }

    /** A short message was received. */
    record MessageReceived(String from, String text) implements RobotEvent {
        @Override
        public Event line(String robot) {
            return about(robot, "sms").with("from", from).with("text", text);
        }
    }

    /** The modem clears the call, which had no key for 60 s; {@link CallReleased} follows. */
    record CallIdle(int seconds) implements RobotEvent {
        @Override
        public Event line(String robot) {
            return about(robot, "call-idle").with("seconds", seconds);
        }
    }

    /** A call was cleared. @param cause of TS 24.008, 10.5.4.11 */
    record CallReleased(int cause) implements RobotEvent {
        @Override
        public Event line(String robot) {
            return about(robot, "released").with("cause", cause);
        }
    }

    /** The robot's status has changed, or was queried. */
    record StatusChanged(RobotStatus status) implements RobotEvent {
        @Override
        public Event line(String robot) {
            return about(robot, "status").with("value", status.text());
        }
    }

    /** The battery has become low, or has been charged. */
    record BatteryChanged(boolean isLow) implements RobotEvent {
        @Override
        public Event line(String robot) {
            return about(robot, "battery").with("state", isLow ? "low" : "ok");
        }
    }

    /** The autonomous process has changed, or was queried. */
    record BehaviourChanged(BehaviourKind kind) implements RobotEvent {
        @Override
        public Event line(String robot) {
            return about(robot, "behaviour").with("value", kind.text());
        }
    }

    /**
     * The autonomous process has thrown something, has not decided in time, or cannot be compiled.
     *
     * @param line of its source; 0 if unknown
     */
    record BehaviourFailed(String name, int line, String text) implements RobotEvent {
        @Override
        public Event line(String robot) {
            return about(robot, "behaviour-failed")
                    .with("name", name)
                    .with("line", line)
                    .with("text", text);
        }
    }

    /** The robot has come to the place to which a process drove it. */
    record Arrived(Pose pose) implements RobotEvent {
        @Override
        public Event line(String robot) {
            return about(robot, "arrived").with("x", pose.xText(4)).with("y", pose.yText(4));
        }
    }

    /** The pose after an instruction, or when queried. */
    record PoseReported(Pose pose) implements RobotEvent {
        @Override
        public Event line(String robot) {
            return about(robot, "pose")
                    .with("x", pose.xText(4))
                    .with("y", pose.yText(4))
                    .with("heading", pose.headingText(2));
        }
    }

    /** A real robot's type is not known, so it is not moved. @param type as the robot names it */
    record TypeUnknown(String type) implements RobotEvent {
        @Override
        public Event line(String robot) {
            return about(robot, "error")
                    .with("text", "robot type " + type + " is not known: no motion; expected --pioneer-params FILE.p");
        }
    }

    /** A Pioneer program sent a text for the operator. */
    record ClientMessage(String text) implements RobotEvent {
        @Override
        public Event line(String robot) {
            return about(robot, "client-message").with("text", text);
        }
    }

    private static Event about(String robot, String name) {
        return Event.of(name).with("robot", robot);
    }

    /**
     * Returns the event of a printed line; empty if the log does not keep it (keys, tones, poses) or a later version
     * wrote it.
     */
    static Optional<RobotEvent> of(String name, Map<String, String> fields) {
        try {
            return Optional.ofNullable(
                    switch (name) {
                        case "added" -> new Added(field(fields, "number"));
                        case "removed" -> new Removed(field(fields, "number"));
                        case "registered" -> new Registered(field(fields, "number"));
                        case "unregistered" -> new Unregistered(field(fields, "cause"));
                        case "modem" ->
                            new ModemChanged(ModemState.ofWord(field(fields, "state")), field(fields, "text"));
                        case "ringing" -> new CallRinging(field(fields, "from"));
                        case "call" -> new CallReceived(field(fields, "from"));
                        case "order" -> new OrderVerified(field(fields, "text"), field(fields, "verdict"));
                        case "outcome" ->
                            new OrderAnswered(Integer.parseInt(field(fields, "tone")), field(fields, "text"));
                        case "reply" -> new ReplySent(field(fields, "to"), field(fields, "text"));
                        case "reply-failed" -> new ReplyFailed(field(fields, "to"), field(fields, "text"));
                        case "sms" -> new MessageReceived(field(fields, "from"), field(fields, "text"));
                        case "ussd" -> new UssdAnswered(field(fields, "text"), field(fields, "reply"));
                        case "call-idle" -> new CallIdle(Integer.parseInt(field(fields, "seconds")));
                        case "released" -> new CallReleased(Integer.parseInt(field(fields, "cause")));
                        case "status" -> new StatusChanged(RobotStatus.ofText(field(fields, "value")));
                        case "battery" ->
                            new BatteryChanged(field(fields, "state").equals("low"));
                        case "client-message" -> new ClientMessage(field(fields, "text"));
                        case "behaviour" -> new BehaviourChanged(BehaviourKind.shown(field(fields, "value")));
                        case "behaviour-failed" ->
                            new BehaviourFailed(
                                    field(fields, "name"),
                                    Integer.parseInt(field(fields, "line")),
                                    field(fields, "text"));
                        default -> null;
                    });
        } catch (IllegalArgumentException unknownValue) {
            return Optional.empty();
        }
    }

    private static String field(Map<String, String> fields, String key) {
        return fields.getOrDefault(key, "");
    }
}
