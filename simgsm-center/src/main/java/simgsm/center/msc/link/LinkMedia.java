package simgsm.center.msc.link;

import java.lang.System.Logger.Level;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import simgsm.abis.IpaFrame;
import simgsm.abis.MgcpMessage;
import simgsm.abis.MgcpMessage.MediaAddress;
import simgsm.air.ProtocolViolation;

/**
 * The speech of one link's calls: as RTP over UDP if the exchange is set so and the terminal agrees (MGCP, RFC 3435),
 * else as frames of the link. A session begins when a call alerts and ends with the link's last call.
 */
public final class LinkMedia {
    private static final System.Logger LOG = System.getLogger(LinkMedia.class.getName());

    private static final int COUNTS = 256;
    /** Frames of 20 ms. */
    private static final int MOST_WAITING = 10;

    private enum State {
        CLOSED,
        /** CRCX is sent; the first 200 ms of speech wait for the answer, later frames are sent by the link. */
        CREATING,
        OPEN
    }

    private final Link link;
    private final LinkPort port;
    private final boolean isOverUdp;
    private State state = State.CLOSED;
    private int transaction;
    private int calls;
    private String connection = "";
    private final Deque<IpaFrame> waiting = new ArrayDeque<>();
    /** Frames of the session that have waited. */
    private int delayed;

    LinkMedia(Link link, LinkPort port, boolean isOverUdp) {
        this.link = link;
        this.port = port;
        this.isOverUdp = isOverUdp;
    }

    /** @param isInUse true if a call of this link needs the speech path */
    public void setInUse(boolean isInUse) {
        if (isInUse && state == State.CLOSED && isOverUdp) {
            create();
        } else if (!isInUse && state != State.CLOSED) {
            delete();
        }
    }

    private void create() {
        Optional<MediaAddress> own = port.openMedia();
        if (own.isPresent()) {
            calls++;
            state = State.CREATING;
            delayed = 0;
            send(MgcpMessage.create(++transaction, callId(), own.get()));
        }
    }

    /** Deletes the connection; while its identifier is unknown, all connections of the call (RFC 3435, 2.3.9). */
    private void delete() {
        Optional<String> known = state == State.OPEN ? Optional.of(connection) : Optional.empty();
        send(MgcpMessage.delete(++transaction, callId(), known));
        close();
    }

    /** The subscriber's number and a count, unique among links. */
    private String callId() {
        return link.lifeline() + String.format("%02x", calls % COUNTS);
    }

    private void send(MgcpMessage message) {
        port.send(new IpaFrame(IpaFrame.MGCP, message.encode()));
    }

    void close() {
        state = State.CLOSED;
        port.closeMedia();
        waiting.clear();
    }

    /** Handles the terminal's answer. */
    public void receive(byte[] octets) throws ProtocolViolation {
        MgcpMessage answer = MgcpMessage.decode(octets);
        if (state != State.CREATING || answer.transaction() != transaction) {
            return;
        }
        boolean isTaken = answer.head() == MgcpMessage.Head.OK
                && answer.media().isPresent()
                && port.connectMedia(answer.media().get());
        if (isTaken) {
            state = State.OPEN;
            connection = answer.connection().orElse("1");
            sendWaiting();
        } else {
            LOG.log(Level.INFO, "{0}: no RTP over UDP, speech goes with the signalling", link);
            sendWaiting();
            close();
        }
    }

    void sendSpeech(IpaFrame frame) {
        if (state == State.CREATING && delayed < MOST_WAITING) {
            delayed++;
            waiting.add(frame);
        } else {
            sendWaiting();
            sendNow(frame);
        }
    }

    private void sendWaiting() {
        waiting.forEach(this::sendNow);
        waiting.clear();
    }

    private void sendNow(IpaFrame frame) {
        if (state != State.OPEN || !port.sendMedia(frame.payload())) {
            port.send(frame);
        }
    }
}
