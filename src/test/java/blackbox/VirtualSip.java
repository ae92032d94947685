package blackbox;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import simgsm.air.Msisdn;
import simgsm.gateway.sip.SipListener;
import simgsm.gateway.sip.SipPeer;
import simgsm.gateway.sip.SipServer;
import simgsm.gateway.sip.SipTransport;
import simgsm.gateway.sip.SipUser;
import simgsm.station.MobileStation;
import simgsm.timer.Timers;

/** The gateway's SIP core on the network of a {@link VirtualSuite}; its datagrams are handed over in memory and may be lost. */
final class VirtualSip implements SipTransport, SipListener {
    static final String HOST = "192.0.2.1";
    static final String PASSWORD = "secret";

    final VirtualSuite suite;
    final List<String> told = new ArrayList<>();
    final List<Integer> openMedia = new ArrayList<>();
    private final Timers timers = new Timers();
    private final Map<SipPeer, VirtualSipPhone> phones = new HashMap<>();
    private final Map<Integer, BiConsumer<byte[], SipPeer>> media = new HashMap<>();
    private final SipServer server;
    private int nextPort = 20_000;
    private long nowNanos;
    private BooleanSupplier isLost = () -> false;

    VirtualSip(VirtualSuite suite) {
        this.suite = suite;
        Map<String, String> passwords = new HashMap<>();
        for (int i = 0; i < 300; i++) {
            passwords.put(Integer.toString(5_550_300 + i), PASSWORD);
        }
        server = new SipServer(timers, this, passwords, new SplittableRandom(1), new SplittableRandom(2), this);
        suite.tellTime(this::timeIs);
    }

    /** As in the gateway, the clock of the core moves at deadlines, datagrams and events of stations alone. */
    private void timeIs(long nanos) {
        nowNanos = nanos;
        if (timers.nextDeadlineNanos().orElse(Long.MAX_VALUE) <= nanos) {
            timers.advance(nanos);
        }
    }

    @Override
    public void timePassed() {
        timers.advance(nowNanos);
    }

    /** From now on datagrams are lost where this says so, in both directions. */
    void lose(BooleanSupplier when) {
        isLost = when;
    }

    List<String> users() {
        return server.users().stream()
                .filter(SipUser::isRegistered)
                .map(user -> user.number() + " " + user.from() + (user.isCalling() ? " call" : " idle"))
                .toList();
    }

    SipServer server() {
        return server;
    }

    void plug(VirtualSipPhone phone) {
        phones.put(phone.signalling, phone);
        phones.put(phone.speech, phone);
    }

    /** A datagram to the port of SIP. */
    void toServer(byte[] octets, SipPeer from) {
        if (!isLost.getAsBoolean()) {
            suite.later(() -> {
                timePassed();
                server.arrived(octets, from);
            });
        }
    }

    /** A datagram to a port of speech. */
    void toMedia(int port, byte[] octets, SipPeer from) {
        if (!isLost.getAsBoolean() && media.containsKey(port)) {
            timePassed();
            media.get(port).accept(octets, from);
        }
    }

    @Override
    public void send(byte[] octets, SipPeer to) {
        if (!isLost.getAsBoolean() && phones.containsKey(to)) {
            suite.later(() -> phones.get(to).arrived(octets));
        }
    }

    @Override
    public String hostTowards(SipPeer peer) {
        return HOST;
    }

    @Override
    public int port() {
        return 5060;
    }

    @Override
    public Media openMedia(BiConsumer<byte[], SipPeer> received) {
        int port = nextPort += 2;
        media.put(port, received);
        openMedia.add(port);
        return new Media() {
            @Override
            public int port() {
                return port;
            }

            @Override
            public void send(byte[] octets, SipPeer to) {
                if (!isLost.getAsBoolean() && phones.containsKey(to)) {
                    phones.get(to).heard(octets);
                }
            }

            @Override
            public void close() {
                media.remove(port);
                openMedia.remove((Integer) port);
            }
        };
    }

    @Override
    public void add(MobileStation station) {
        suite.later(() -> suite.join(station));
    }

    @Override
    public void remove(MobileStation station, Runnable gone) {
        station.powerOff();
        suite.later(gone);
    }

    @Override
    public void joined(Msisdn number, String from) {
        told.add("joined " + number);
    }

    @Override
    public void left(Msisdn number) {
        told.add("left " + number);
    }

    @Override
    public void refused(String from, int status, String text) {
        told.add("refused " + status + " " + text);
    }
}
