package simgsm.cells.network;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.function.Consumer;
import simgsm.abis.IpaFrame;
import simgsm.abis.RslElement;
import simgsm.abis.RslMessage;
import simgsm.abis.RslPdu;
import simgsm.abis.RslType;
import simgsm.air.ChannelDescription;
import simgsm.air.ChannelNumber;
import simgsm.air.ChannelNumber.Kind;
import simgsm.air.Direction;
import simgsm.air.Imsi;
import simgsm.air.Layer3Codec;
import simgsm.air.LocationArea;
import simgsm.air.MobilityManagement;
import simgsm.air.MobilityManagement.LocationUpdatingRequest;
import simgsm.air.MobilityManagement.LocationUpdatingType;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.cells.mobile.Mobile;
import simgsm.cells.mobile.MobilePort;
import simgsm.cells.mobile.MobileRadioTable.MobileRadioState;
import simgsm.cells.tower.BaseStation;
import simgsm.cells.tower.SpeechSocket;
import simgsm.cells.tower.TowerPort;
import simgsm.cells.town.Tower;
import simgsm.cells.town.Town;
import simgsm.cells.town.TownPlace;
import simgsm.octets.OctetString;
import simgsm.rr.ImmediateAssignment;
import simgsm.rr.NeighbourList;
import simgsm.rr.RequestReference;
import simgsm.rr.SystemInformation;
import simgsm.rr.SystemInformation.ControlChannel;
import simgsm.rr.SystemInformation.RandomAccess;
import simgsm.rr.SystemInformation.SelectionParameters;

/** Measures the processor time of 1 000 mobiles that walk among 50 towers, idle and in connections. Run by hand. */
public final class ManyMobilesBench {
    private static final int TOWERS = 50;
    private static final int MOBILES = 1_000;
    private static final int SECONDS = 60;
    private static final long SECOND_NANOS = 1_000_000_000L;
    private static final double SIDE_METRES = 10_000;

    /** Grants every CHANNEL REQUEST the next channel and releases none. */
    private static final class GrantingController implements TowerPort {
        private final BaseStation tower;
        private int granted;

        GrantingController(BaseStation tower) {
            this.tower = tower;
        }

        void connect(List<Integer> frequencies) {
            tower.connected(this);
            SystemInformation.Type3 cell = new SystemInformation.Type3(
                    tower.tower().site(),
                    LocationArea.TEST,
                    new ControlChannel(true, 1, true, 2, 0),
                    64,
                    new SelectionParameters(4, 5, 0),
                    new RandomAccess(7, 9, false),
                    Optional.empty());
            down(RslPdu.of(RslType.BCCH_INFORMATION, ChannelNumber.of(Kind.BCCH, 0))
                    .with(RslElement.FULL_BCCH_INFORMATION, cell.encode()));
            down(RslPdu.of(RslType.SACCH_FILLING)
                    .with(
                            RslElement.L3_INFORMATION,
                            new SystemInformation.Neighbours(NeighbourList.TYPE_5, frequencies).encode()));
        }

        private void down(RslPdu message) {
            tower.frameArrived(new IpaFrame(IpaFrame.RSL, message.encode()));
        }

        @Override
        public void send(IpaFrame frame) {
            if (frame.stream() != IpaFrame.RSL) {
                return;
            }
            try {
                RslPdu message = RslPdu.decode(frame.payload());
                if (message.type() == RslType.CHANNEL_REQUIRED) {
                    grant(RequestReference.of(message.value(RslElement.REQUEST_REFERENCE)));
                }
            } catch (ProtocolViolation e) {
                throw new AssertionError(e);
            }
        }

        private void grant(RequestReference reference) {
            ChannelNumber channel = new ChannelNumber(Kind.SDCCH_8, granted % 8, granted / 8 % 8);
            granted++;
            down(RslPdu.of(RslType.CHANNEL_ACTIVATION, channel).with(RslElement.ACTIVATION_TYPE, 0));
            down(RslPdu.of(RslType.IMMEDIATE_ASSIGN_COMMAND, ChannelNumber.of(Kind.PCH_AGCH, 0))
                    .with(
                            RslElement.FULL_IMMEDIATE_ASSIGN,
                            new ImmediateAssignment(
                                            new ChannelDescription(
                                                    channel, 0, tower.tower().arfcn()),
                                            reference,
                                            0)
                                    .encode()));
        }

        @Override
        public Optional<SpeechSocket> openSpeech(Consumer<byte[]> received) {
            return Optional.empty();
        }

        @Override
        public void drop(String reason) {}
    }

    private ManyMobilesBench() {}

    public static void main(String[] args) throws ProtocolViolation {
        Random random = new Random(1);
        List<Tower> towers = new ArrayList<>();
        List<Integer> frequencies = new ArrayList<>();
        for (int i = 0; i < TOWERS; i++) {
            frequencies.add(1 + 2 * i);
            towers.add(new Tower("t" + i, place(random), 30, 43, 1 + 2 * i, i, 1, 7_000 + i));
        }
        CellNetwork network = new CellNetwork(new Town(towers), 1, event -> {});
        network.towers().forEach(tower -> new GrantingController(tower).connect(frequencies));
        List<Mobile> mobiles = new ArrayList<>();
        for (int i = 0; i < MOBILES; i++) {
            mobiles.add(connect(network, 7_000_000 + i, random));
        }
        run(network, 10, "registering");
        long connected = mobiles.stream()
                .filter(mobile -> mobile.state() == MobileRadioState.DEDICATED)
                .count();
        run(network, SECONDS, connected + " of " + MOBILES + " in connections, with reports");
        for (Mobile mobile : mobiles) {
            mobile.arrived(new RslMessage.ReleaseIndication(RslMessage.Sapi.SIGNALLING));
        }
        run(network, SECONDS, MOBILES + " idle");
    }

    private static TownPlace place(Random random) {
        return new TownPlace(SIDE_METRES * (random.nextDouble() - 0.5), SIDE_METRES * (random.nextDouble() - 0.5));
    }

    private static Mobile connect(CellNetwork network, long number, Random random) throws ProtocolViolation {
        Mobile mobile = network.connected(
                new MobilePort() {
                    @Override
                    public void send(IpaFrame frame) {}

                    @Override
                    public void close(String reason) {}
                },
                "terminal");
        network.place(Long.toString(number), place(random));
        byte[] request = Layer3Codec.encode(
                new LocationUpdatingRequest(
                        LocationUpdatingType.IMSI_ATTACH,
                        MobilityManagement.NO_KEY,
                        LocationArea.TEST,
                        Imsi.ofOpenNumber(new Msisdn(Long.toString(number)))),
                Direction.UPLINK,
                0);
        mobile.arrived(new RslMessage.EstablishIndication(RslMessage.Sapi.SIGNALLING, OctetString.of(request)));
        mobile.walker().walk(List.of(place(random), place(random), place(random)), 15);
        return mobile;
    }

    /** Of the whole process, compiler and collector included. */
    private static long cpuNanos() {
        return ProcessHandle.current().info().totalCpuDuration().orElseThrow().toNanos();
    }

    private static void run(CellNetwork network, int seconds, String what) {
        long begin = cpuNanos();
        long start = network.nowNanos();
        for (long millis = 10; millis <= seconds * 1_000L; millis += 10) {
            network.advance(start + millis * SECOND_NANOS / 1_000);
        }
        long cpu = cpuNanos() - begin;
        System.out.printf(
                Locale.ROOT, "%s: %.1f %% of a core%n", what, 100.0 * cpu / (seconds * (double) SECOND_NANOS));
    }
}
