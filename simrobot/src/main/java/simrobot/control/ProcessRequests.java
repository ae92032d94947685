package simrobot.control;

import java.util.function.Consumer;
import java.util.function.LongSupplier;
import simrobot.behaviour.Requests;
import simrobot.process.BehaviourKind;

/** Does what the process of one robot asks of its telephone, and tells what it prints. For the simulation's thread. */
final class ProcessRequests {
    /** A robot sends at most one SMS of its process in this time, so that a loop does not flood the network. */
    static final long MESSAGE_NANOS = 10_000_000_000L;

    /** A tone of 150 ms and its pause of 70 ms. */
    private static final long TONE_NANOS = 220_000_000;

    private final ModemPort modem;
    private final LongSupplier callNumber;
    private final LongSupplier clockNanos;
    private final Consumer<RobotEvent> listener;
    private long messageNanos;
    private long tonesEndNanos;
    private boolean isRefused;

    ProcessRequests(
            ModemPort modem, LongSupplier callNumber, LongSupplier clockNanos, Consumer<RobotEvent> listener) {
        this.modem = modem;
        this.callNumber = callNumber;
        this.clockNanos = clockNanos;
        this.listener = listener;
        messageNanos = clockNanos.getAsLong() - MESSAGE_NANOS;
        tonesEndNanos = clockNanos.getAsLong();
    }

    void perform(BehaviourKind kind, Requests asked) {
        asked.printed().forEach(line -> listener.accept(new RobotEvent.Printed(kind.text(), line)));
        asked.messages().forEach(message -> send(kind.text(), message));
        long now = clockNanos.getAsLong();
        if (!asked.tones().isEmpty() && now - tonesEndNanos >= 0) {
            asked.tones().chars().forEach(key -> modem.sendTone(callNumber.getAsLong(), (char) key));
            tonesEndNanos = now + TONE_NANOS * asked.tones().length();
        }
    }

    /** A refusal is told once until the next message leaves. */
    private void send(String process, Requests.Message message) {
        long now = clockNanos.getAsLong();
        if (now - messageNanos < MESSAGE_NANOS) {
            if (!isRefused) {
                listener.accept(new RobotEvent.RequestRefused(process + ": sms to " + message.to()
                        + " is not sent, expected at most one in 10 s"));
            }
            isRefused = true;
        } else if (modem.sendMessage(message.to(), message.text())) {
            messageNanos = now;
            isRefused = false;
            listener.accept(new RobotEvent.ReplySent(message.to(), message.text()));
        }
    }
}
