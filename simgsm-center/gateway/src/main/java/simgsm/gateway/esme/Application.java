package simgsm.gateway.esme;

import java.util.function.Consumer;
import java.util.function.IntConsumer;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppStatus;
import simgsm.timer.Timers;

/** An application of the SMSC: one session after another, and the texts that they deliver. */
public final class Application {
    /** Receives the events of the bind. */
    public interface Listener {
        /** The SMSC has answered the bind. @param status of SMPP; 0 for a bound application */
        void bound(int status);

        /** The application is bound no longer. */
        void unbound();
    }

    /** Instead of a command_status: the connection has ended before the answer. */
    public static final int LOST = -1;

    private final Timers timers;
    private final BindSettings settings;
    private final Listener listener;
    private final DeliveredTexts texts;
    /** Null while not bound. */
    private ApplicationSession session;

    /** @param whole receives each text once all its parts are there, and has it answered by {@link #answer} */
    public Application(Timers timers, BindSettings settings, Listener listener, Consumer<TextDelivery> whole) {
        this.timers = timers;
        this.settings = settings;
        this.listener = listener;
        texts = new DeliveredTexts(timers, whole);
    }

    /** The protocol of a new connection to the SMSC. */
    public TcpProtocol connection() {
        return new ApplicationSession(timers, settings, new ApplicationSession.Listener() {
            @Override
            public void bound(ApplicationSession bound, int status) {
                if (status == SmppStatus.OK) {
                    session = bound;
                }
                listener.bound(status);
            }

            @Override
            public void delivered(ApplicationSession from, int sequence, SmppMessage message) {
                texts.delivered(from, sequence, message);
            }

            @Override
            public void ended(ApplicationSession ended) {
                if (session == ended) {
                    session = null;
                    listener.unbound();
                }
            }
        });
    }

    public BindSettings settings() {
        return settings;
    }

    public boolean isBound() {
        return session != null;
    }

    /** Submits a text; the consumer receives command_status, or {@link #LOST}. */
    public void submit(SmppMessage message, IntConsumer answered) {
        if (session == null) {
            answered.accept(LOST);
        } else {
            session.submit(message, answered);
        }
    }

    /** Answers the deliver_sm of all parts. With status 0 the text is taken, and is not delivered again. */
    public void answer(TextDelivery delivery, int status) {
        texts.answer(delivery, status);
    }
}
