package simgsm.gateway.esme;

import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.IntConsumer;
import simgsm.smpp.SmppCodec;
import simgsm.smpp.SmppCommand;
import simgsm.smpp.SmppFramer;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppPdu;
import simgsm.smpp.SmppStatus;
import simgsm.smpp.SmppViolation;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/** One connection of the application to the SMSC: binds as transceiver, submits, answers, and checks the link (SMPP 3.4). */
final class ApplicationSession implements TcpProtocol {
    private static final long ENQUIRE_NANOS = TimeUnit.SECONDS.toNanos(30);
    private static final long ANSWER_NANOS = TimeUnit.SECONDS.toNanos(10);

    /** Receives the events of a session. */
    interface Listener {
        /** @param status {@link SmppStatus#OK} for a bound session */
        void bound(ApplicationSession session, int status);

        /** A deliver_sm, to be answered by {@link #answer}. */
        void delivered(ApplicationSession session, int sequence, SmppMessage message);

        void ended(ApplicationSession session);
    }

    private final Timers timers;
    private final BindSettings settings;
    private final Listener listener;
    private final SmppFramer framer = new SmppFramer();
    private final Map<Integer, IntConsumer> unanswered = new HashMap<>();
    private TcpSocket socket;
    private Timer silence;
    private boolean isEnquired;
    private int sequence;

    ApplicationSession(Timers timers, BindSettings settings, Listener listener) {
        this.timers = timers;
        this.settings = settings;
        this.listener = listener;
    }

    @Override
    public void connected(TcpSocket opened) {
        socket = opened;
        send(new SmppPdu.Bind(
                SmppCommand.BIND_TRANSCEIVER,
                ++sequence,
                settings.systemId(),
                settings.password(),
                "",
                SmppCodec.INTERFACE_VERSION,
                settings.addressRange()));
        silence = timers.start(ANSWER_NANOS, this::end);
    }

    @Override
    public void received(ByteBuffer octets) {
        framer.accept(octets);
        heard();
        try {
            while (socket != null && framer.hasNext()) {
                take(framer.next());
            }
        } catch (SmppViolation wrong) {
            end();
        }
    }

    private void heard() {
        timers.cancel(silence);
        isEnquired = false;
        silence = timers.start(ENQUIRE_NANOS, this::enquire);
    }

    private void enquire() {
        if (isEnquired) {
            end();
            return;
        }
        isEnquired = true;
        send(new SmppPdu.Plain(SmppCommand.ENQUIRE_LINK, ++sequence));
        silence = timers.start(ANSWER_NANOS, this::enquire);
    }

    private void take(SmppPdu pdu) {
        if (pdu instanceof SmppPdu.BindResponse response) {
            listener.bound(this, response.status());
            if (response.status() != SmppStatus.OK) {
                end();
            }
        } else if (pdu instanceof SmppPdu.Message message && message.command() != SmppCommand.SUBMIT_SM) {
            listener.delivered(this, message.sequence(), message.message());
        } else if (pdu instanceof SmppPdu.Response response) {
            IntConsumer waiting = unanswered.remove(response.sequence());
            if (waiting != null) {
                waiting.accept(response.status());
            }
        } else if (pdu instanceof SmppPdu.Plain request) {
            send(new SmppPdu.PlainResponse(request.command(), SmppStatus.OK, request.sequence()));
            if (request.command() == SmppCommand.UNBIND) {
                end();
            }
        } else {
            send(new SmppPdu.GenericNack(SmppStatus.INVALID_COMMAND_ID, pdu.sequence()));
        }
    }

    /** Submits a text; the consumer receives command_status, or {@link Application#LOST}. */
    void submit(SmppMessage message, IntConsumer answered) {
        unanswered.put(++sequence, answered);
        send(new SmppPdu.Message(SmppCommand.SUBMIT_SM, sequence, message));
    }

    void answer(int number, int status) {
        send(new SmppPdu.MessageResponse(SmppCommand.DELIVER_SM, status, number, ""));
    }

    private void send(SmppPdu pdu) {
        if (socket != null) {
            socket.send(SmppCodec.encode(pdu));
        }
    }

    private void end() {
        if (socket != null) {
            socket.closeWhenSent();
            lost("ended");
        }
    }

    @Override
    public void lost(String reason) {
        timers.cancel(silence);
        socket = null;
        List<IntConsumer> waiting = List.copyOf(unanswered.values());
        unanswered.clear();
        waiting.forEach(each -> each.accept(Application.LOST));
        listener.ended(this);
    }
}
