package simgsm.center.app;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import simgsm.air.Msisdn;
import simgsm.center.bsc.handover.HandoverAlgorithm;
import simgsm.center.capture.CapturePlan;
import simgsm.center.net.PortLimits;
import simgsm.console.Arguments;
import simgsm.console.UsageException;
import simgsm.tone.ToneSet;

/**
 * The options of the command line.
 *
 * @param port empty for the default
 * @param smppPort empty for no SMPP
 * @param data empty for the default directory
 * @param capture empty for none
 * @param httpPort empty for no HTTP
 * @param records folder of call and message records; empty for none
 * @param home the SIMs that may register
 * @param tones made by the network; empty if phones make them
 * @param limits of connections
 * @param callWaiting true to offer a second call to a busy phone
 * @param speaksUdp true to send speech as RTP over UDP
 * @param setupSeconds T303: time for a called phone to answer SETUP
 * @param emergencyNumber who answers 112 and 911; empty for a notice
 * @param handover decides on handovers of calls over towers
 */
public record CenterSettings(
        InetAddress address,
        OptionalInt port,
        OptionalInt smppPort,
        Optional<Path> data,
        Optional<CapturePlan> capture,
        OptionalInt httpPort,
        Optional<Path> records,
        HomeSettings home,
        RandomGenerator random,
        Locale language,
        Optional<ToneSet> tones,
        PortLimits limits,
        boolean callWaiting,
        boolean speaksUdp,
        int setupSeconds,
        Optional<Msisdn> emergencyNumber,
        HandoverAlgorithm handover) {
    private static final int T303_SECONDS = 30;
    private static final int LONGEST_T303_SECONDS = 300;
    public static final int DEFAULT_PORT = 3003;
    private static final int MAX_PORT = 0xffff;

    /** @throws IOException naming an unreadable file of SIMs */
    public static CenterSettings read(Arguments arguments) throws UsageException, IOException {
        return new CenterSettings(
                arguments.bindAddress(),
                port(arguments, "port"),
                port(arguments, "smpp"),
                arguments.path("data"),
                capture(arguments),
                port(arguments, "http"),
                arguments.path("cdr"),
                HomeSettings.read(arguments),
                random(arguments),
                arguments.language(),
                arguments.value("tones", ToneSet::of),
                limits(arguments),
                arguments.choice("call-waiting", "off", "on").equals("on"),
                arguments.choice("rtp", "tcp", "udp").equals("udp"),
                (int) arguments.integer("t303", T303_SECONDS, 1, LONGEST_T303_SECONDS),
                arguments.value("emergency", Msisdn::new),
                arguments.value("handover", HandoverAlgorithm::of).orElse(HandoverAlgorithm.STANDARD));
    }

    private static PortLimits limits(Arguments arguments) throws UsageException {
        PortLimits standard = PortLimits.STANDARD;
        return new PortLimits(
                limit(arguments, "max-terminals", standard.terminals()),
                limit(arguments, "max-terminals-per-address", standard.terminalsPerAddress()),
                limit(arguments, "max-applications", standard.applications()),
                limit(arguments, "max-applications-per-address", standard.applicationsPerAddress()));
    }

    private static int limit(Arguments arguments, String option, int standard) throws UsageException {
        return (int) arguments.integer(option, standard, 1, PortLimits.LARGEST);
    }

    private static Optional<CapturePlan> capture(Arguments arguments) throws UsageException {
        if (arguments.has("capture-limit") && !arguments.has("capture")) {
            throw new UsageException("--capture-limit needs --capture FILE.pcap");
        }
        long limitMib =
                arguments.integer("capture-limit", CapturePlan.DEFAULT_LIMIT_MIB, 1, CapturePlan.LARGEST_LIMIT_MIB);
        return arguments.path("capture").map(file -> CapturePlan.of(file, limitMib));
    }

    /**
     * The source of challenges and temporary identities: unpredictable, unless {@code --seed} makes a run repeatable.
     */
    private static RandomGenerator random(Arguments arguments) throws UsageException {
        return arguments.has("seed")
                ? new SplittableRandom(arguments.integer("seed", 0, Long.MIN_VALUE, Long.MAX_VALUE))
                : new SecureRandom();
    }

    private static OptionalInt port(Arguments arguments, String option) throws UsageException {
        int port = (int) arguments.integer(option, 0, 0, MAX_PORT);
        return arguments.has(option) ? OptionalInt.of(port) : OptionalInt.empty();
    }
}
