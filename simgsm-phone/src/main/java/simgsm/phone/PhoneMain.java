package simgsm.phone;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.console.Arguments;
import simgsm.console.Console;
import simgsm.console.Event;
import simgsm.console.ExitStatus;
import simgsm.console.HostPort;
import simgsm.console.Options;
import simgsm.console.Program;
import simgsm.console.UnavailableException;
import simgsm.console.UsageException;
import simgsm.phone.handset.HandsetListener;
import simgsm.phone.ui.HandsetWindow;
import simgsm.speech.AudioOutput;
import simgsm.speech.SpeechCodec;
import simgsm.station.StationIdentity;
import simgsm.station.StationOptions;
import simgsm.ui.ProgramWindow;
import simgsm.ui.Texts;

/** Starts a phone, with its window or on a console. */
public final class PhoneMain {
    private static final String DEFAULT_NUMBER = "5550100";
    private static final HostPort DEFAULT_CENTER = new HostPort("127.0.0.1", 3003);
    private static final String UNIT_NAME = "SimGSM phone";

    private PhoneMain() {}

    public static void main(String[] args) {
        new Program("simgsm-phone", options()).runAndExit(args, PhoneMain::run);
    }

    static Options options() {
        return Program.commonOptions(
                        "java -jar simgsm-phone.jar --number 5550101 [options]",
                        "A GSM phone (M1): dial a robot, key its orders, hear its answers, send short messages.")
                .value("number", "N", "the phone's own number, 1 to 10 digits (5550100)")
                .value("center", "HOST:PORT", "the SMS/Phone centre (127.0.0.1:3003)")
                .value("codec", "alaw|gsm", "how the phone's speech is coded; it understands both (alaw)")
                .value("imei", "IMEI", "the equipment's identity, 15 digits; else a random one");
    }

    static int run(Arguments arguments) throws Exception {
        StationIdentity identity = identity(arguments);
        HostPort center = arguments.hostPort("center").orElse(DEFAULT_CENTER);
        StationOptions options = new StationOptions(codec(arguments));
        Locale language = arguments.language();
        return arguments.has("headless")
                ? headless(arguments, identity, options, center, Messages.in(language))
                : windowed(arguments, identity, options, center, Messages.in(language));
    }

    private static StationIdentity identity(Arguments arguments) throws UsageException {
        Msisdn number = arguments.value("number", Msisdn::parse).orElse(new Msisdn(DEFAULT_NUMBER));
        Random random = new Random();
        if (arguments.has("seed")) {
            // With the number, or two phones of one seed would be one piece of equipment.
            random = new Random(arguments.integer("seed", 0, Long.MIN_VALUE, Long.MAX_VALUE) * 31
                    + number.digits().hashCode());
        }
        Imei imei = arguments.value("imei", Imei::new).orElse(Imei.random(random));
        try {
            return StationIdentity.ofOpenNumber(number, imei, UNIT_NAME);
        } catch (IllegalArgumentException e) {
            throw new UsageException("--number: " + e.getMessage());
        }
    }

    private static SpeechCodec.Kind codec(Arguments arguments) throws UsageException {
        return arguments.choice("codec", "alaw", "gsm").equals("gsm")
                ? SpeechCodec.Kind.GSM_FULL_RATE
                : SpeechCodec.Kind.A_LAW;
    }

    static InetSocketAddress address(HostPort center) {
        return new InetSocketAddress(center.host(), center.port());
    }

    static AudioOutput sound(Arguments arguments) {
        return arguments.has("no-sound") ? AudioOutput.SILENT : AudioOutput.open();
    }

    private static int windowed(
            Arguments arguments, StationIdentity identity, StationOptions options, HostPort center, Texts texts)
            throws UsageException, UnavailableException, InterruptedException {
        ProgramWindow window = ProgramWindow.of(arguments, Optional.empty());
        Locale language = arguments.language();
        Phone phone = new Phone(identity, options, new HandsetListener() {}, sound(arguments));
        Runtime.getRuntime().addShutdownHook(new Thread(phone::close, "detach"));
        phone.start(address(center));
        window.show(() -> HandsetWindow.content(
                identity.number().digits(), texts, language, phone.handset()::snapshot, new PhoneControls(phone)));
        phone.close();
        return ExitStatus.OK;
    }

    private static int headless(
            Arguments arguments, StationIdentity identity, StationOptions options, HostPort center, Texts texts)
            throws IOException, InterruptedException, UsageException {
        Console console = new Console(Program.standardOutput());
        Phone phone = new Phone(identity, options, new EventPrinter(console, texts), AudioOutput.SILENT);
        PhoneCommands commands = new PhoneCommands(console, phone);
        Thread lastWill = new Thread(phone::close, "detach");
        Runtime.getRuntime().addShutdownHook(lastWill);
        console.ready(Event.of("ready"));
        phone.start(address(center));
        try {
            Program.runConsole(console, arguments, commands);
            commands.finish();
        } finally {
            phone.close();
        }
        return console.exitStatus();
    }
}
