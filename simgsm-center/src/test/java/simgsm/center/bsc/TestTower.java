package simgsm.center.bsc;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.abis.CcmCodec;
import simgsm.abis.CcmMessage;
import simgsm.abis.IpaFrame;
import simgsm.abis.MediaPort;
import simgsm.abis.MgcpMessage.MediaAddress;
import simgsm.abis.RslElement;
import simgsm.abis.RslPdu;
import simgsm.abis.RslType;
import simgsm.air.ProtocolViolation;
import simgsm.center.msc.link.LinkPort;
import simgsm.center.msc.link.Peer;
import simgsm.octets.OctetString;

/** A tower's end of the link, octet by octet: what the controller sends piles up, and a test says what goes up. */
final class TestTower implements LinkPort {
    private static final int FIRST_PORT = 20_000;

    final TowerStage stage;
    final String name;
    final Deque<OctetString> received = new ArrayDeque<>();
    /** Sockets for speech at the exchange, one for each activation of a traffic channel. */
    final List<Media> media = new ArrayList<>();

    Optional<String> closedFor = Optional.empty();
    private final Peer peer;

    /** The exchange's socket for one channel. */
    final class Media implements MediaPort {
        private final Consumer<byte[]> exchange;
        final List<byte[]> heard = new ArrayList<>();
        Optional<MediaAddress> tower = Optional.empty();
        boolean isOpen;

        Media(Consumer<byte[]> exchange) {
            this.exchange = exchange;
        }

        @Override
        public Optional<MediaAddress> openMedia() {
            isOpen = true;
            return Optional.of(new MediaAddress("127.0.0.1", FIRST_PORT + 2 * media.indexOf(this)));
        }

        @Override
        public boolean connectMedia(MediaAddress address) {
            tower = Optional.of(address);
            return true;
        }

        @Override
        public boolean sendMedia(byte[] rtp) {
            heard.add(rtp);
            return true;
        }

        @Override
        public void closeMedia() {
            isOpen = false;
        }

        void speak(byte[] rtp) {
            stage.exchange.perform(stage.nowNanos, () -> exchange.accept(rtp));
        }
    }

    TestTower(TowerStage stage, String name, String address, CcmMessage.IdentityResponse identity) {
        this.stage = stage;
        this.name = name;
        peer = stage.exchange.linkOpened(stage.nowNanos, this, address);
        stage.exchange.frameReceived(stage.nowNanos, peer, new IpaFrame(IpaFrame.CCM, CcmCodec.encode(identity)));
    }

    @Override
    public void send(IpaFrame frame) {
        if (frame.stream() == IpaFrame.RSL) {
            received.add(OctetString.of(frame.payload()));
        }
    }

    @Override
    public MediaPort newMedia(Consumer<byte[]> consumer) {
        Media socket = new Media(consumer);
        media.add(socket);
        return socket;
    }

    @Override
    public void close(String reason) {
        closedFor = Optional.of(reason);
    }

    /** Sends a message; blanks are left out. */
    void up(String hex) {
        byte[] octets = OctetString.ofHex(hex.replace(" ", "")).toArray();
        stage.exchange.frameReceived(stage.nowNanos, peer, new IpaFrame(IpaFrame.RSL, octets));
        stage.commit();
    }

    /** The next messages must be these; blanks are left out. */
    void down(String... hex) {
        for (String each : hex) {
            OctetString next = received.poll();
            assertEquals(each.replace(" ", ""), String.valueOf(next), () -> name + ", before " + received);
        }
    }

    /** Nothing more may have come. */
    void quiet() {
        assertEquals(List.of(), List.copyOf(received), name);
    }

    /** The next message of this type; those before it are dropped. */
    RslPdu next(RslType type) {
        while (!received.isEmpty()) {
            try {
                RslPdu pdu = RslPdu.decode(received.remove().toArray());
                if (pdu.type() == type) {
                    return pdu;
                }
            } catch (ProtocolViolation violation) {
                throw new AssertionError(violation);
            }
        }
        throw new AssertionError(name + ": no " + type.title());
    }

    /** The layer 3 message of the next DATA REQUEST. */
    String nextLayer3() {
        return layer3(next(RslType.DATA_REQUEST));
    }

    private static String layer3(RslPdu message) {
        return message.find(RslElement.L3_INFORMATION).orElseThrow().toString();
    }

    void vanish() {
        stage.exchange.linkClosed(stage.nowNanos, peer, "vanished");
    }

    // Whole procedures of a mobile, on the first free SDCCH or the channel named.

    /** Layer 3 as DATA INDICATION. */
    void tell(String channel, String layer3) {
        upLayer3("0302 01" + channel + "0200", layer3);
    }

    void tellSms(String channel, String layer3) {
        upLayer3("0302 01" + channel + "0203", layer3);
    }

    private void upLayer3(String head, String layer3) {
        String octets = layer3.replace(" ", "");
        up(head + "0b" + String.format("%04x", octets.length() / 2) + octets);
    }

    /** A channel request, up to the first message on the channel that is granted. @return the channel */
    String access(String request, String layer3) {
        received.clear();
        up("0c13 0188 13" + request + "1234 1100");
        String channel = channelOf(next(RslType.CHANNEL_ACTIVATION));
        up("0822 01" + channel + "080000");
        next(RslType.IMMEDIATE_ASSIGN_COMMAND);
        upLayer3("0206 01" + channel + "0200", layer3);
        return channel;
    }

    static String channelOf(RslPdu pdu) {
        return pdu.find(RslElement.CHANNEL_NUMBER).orElseThrow().toString();
    }

    /** The mobile leaves the channel, which is free after T3111. */
    void leave(String channel) {
        received.clear();
        up("0209 01" + channel + "0200");
        stage.passMillis(2_000);
        down("082e01" + channel);
        up("0833 01" + channel);
    }

    /** Location updating from request to free channel. @return the TMSI */
    String register(String number, String imei) {
        String channel = access("05", "0508 70 00f110 fffe 33 " + imsi(number));
        assertEquals("051802", nextLayer3());
        tell(channel, "0559 08 " + imei);
        String accept = nextLayer3();
        assertEquals("050200f110", accept.substring(0, 10));
        tell(channel, "051b");
        leave(channel);
        return accept.substring(accept.length() - 8);
    }

    /** IMSI of a number in the open network, as LV: 00101 and ten digits. */
    static String imsi(String number) {
        String digits = "00101" + "0".repeat(10 - number.length()) + number;
        StringBuilder out = new StringBuilder("08").append(digits.charAt(0)).append('9');
        for (int i = 1; i < digits.length(); i += 2) {
            out.append(digits.charAt(i + 1)).append(digits.charAt(i));
        }
        return out.toString();
    }

    /** Follows the assignment that must come on this channel. @return the traffic channel */
    String followAssignment(String channel) {
        RslPdu activation = next(RslType.CHANNEL_ACTIVATION);
        String traffic = channelOf(activation);
        up("0822 01" + traffic + "080000");
        RslPdu command = next(RslType.DATA_REQUEST);
        while (!layer3(command).startsWith("062e")) {
            command = next(RslType.DATA_REQUEST);
        }
        assertEquals(channel, channelOf(command));
        next(RslType.CREATE_CONNECTION);
        up("7e71 01" + traffic + "f80001 f57f000001 f34e20");
        next(RslType.MODIFY_CONNECTION);
        up("7e74 01" + traffic + "f80001");
        up("0206 01" + traffic + "0200");
        tell(traffic, "062900");
        return traffic;
    }
}
