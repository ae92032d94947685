package simgsm.cells.tower;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.abis.MgcpMessage.MediaAddress;
import simgsm.abis.RslElement;
import simgsm.abis.RslPdu;
import simgsm.abis.RslType;
import simgsm.air.ChannelNumber;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;
import simgsm.timer.RateLimit;
import simgsm.timer.Timers;

/** The speech connection between a channel and the controller, by messages of ip.access. */
final class TowerSpeech {
    private static final int RTP_GSM = 3;
    /** Resource not available (TS 48.058, 9.3.26). */
    private static final int UNAVAILABLE = 0x2f;
    /** Maximum rate of the controller's packets: twice the rate of a call; more are dropped. */
    private static final int PACKETS_PER_SECOND = 100;
    /** Burst after a stall of 4 s. */
    private static final int PACKETS_AT_ONCE = 200;

    private final BaseStation tower;
    private final ChannelNumber number;
    private final Timers timers;
    private final Consumer<byte[]> receiver;
    private final RateLimit rate = new RateLimit(PACKETS_PER_SECOND, PACKETS_AT_ONCE);
    private int connection;
    /** Null without a connection. */
    private SpeechSocket socket;

    TowerSpeech(BaseStation tower, ChannelNumber number, Timers timers, Consumer<byte[]> receiver) {
        this.tower = tower;
        this.number = number;
        this.timers = timers;
        this.receiver = receiver;
    }

    void create(RslPdu message) {
        close();
        if (tower.port() == null) {
            return;
        }
        Optional<SpeechSocket> opened = tower.port().openSpeech(this::received);
        // the elements for addresses support only IPv4
        if (opened.isEmpty() || opened.get().address().host().contains(":")) {
            opened.ifPresent(SpeechSocket::close);
            tower.send(RslPdu.of(RslType.CREATE_CONNECTION_NEGATIVE_ACKNOWLEDGE, number)
                    .with(RslElement.CAUSE, UNAVAILABLE));
            return;
        }
        socket = opened.get();
        connection++;
        connect(message);
        tower.send(connected(RslType.CREATE_CONNECTION_ACKNOWLEDGE));
    }

    /** Changes the peer's address. @param modified runs before the acknowledgement */
    void modify(RslPdu message, Runnable modified) {
        if (socket == null || !connect(message)) {
            tower.send(answer(RslType.MODIFY_CONNECTION_NEGATIVE_ACKNOWLEDGE).with(RslElement.CAUSE, UNAVAILABLE));
        } else {
            modified.run();
            tower.send(connected(RslType.MODIFY_CONNECTION_ACKNOWLEDGE));
        }
    }

    void delete() {
        close();
        tower.send(answer(RslType.DELETE_CONNECTION_ACKNOWLEDGE));
    }

    /** Connects to the address in the message, if there is one. */
    private boolean connect(RslPdu message) {
        if (!message.has(RslElement.REMOTE_IP) || !message.has(RslElement.REMOTE_PORT)) {
            return true;
        }
        OctetString port = message.find(RslElement.REMOTE_PORT).orElseThrow();
        try {
            String host = InetAddress.getByAddress(
                            message.find(RslElement.REMOTE_IP).orElseThrow().toArray())
                    .getHostAddress();
            return socket.connect(new MediaAddress(host, port.octet(0) << 8 | port.octet(1)));
        } catch (UnknownHostException e) {
            return false;
        }
    }

    private RslPdu connected(RslType type) {
        MediaAddress own = socket.address();
        OctetWriter host = new OctetWriter();
        for (String part : own.host().split("\\.")) {
            host.octet(Integer.parseInt(part));
        }
        return answer(type)
                .with(RslElement.LOCAL_IP, host.toOctetString())
                .with(RslElement.LOCAL_PORT, own.port() >> 8, own.port())
                .with(RslElement.RTP_PAYLOAD_2, RTP_GSM);
    }

    private RslPdu answer(RslType type) {
        return RslPdu.of(type, number).with(RslElement.CONNECTION_IDENTIFIER, connection >> 8, connection);
    }

    private void received(byte[] rtp) {
        if (rate.take(timers.nowNanos())) {
            receiver.accept(rtp);
        }
    }

    void send(byte[] rtp) {
        if (socket != null) {
            socket.send(rtp);
        }
    }

    void close() {
        if (socket != null) {
            socket.close();
            socket = null;
        }
    }
}
