package simgsm.gateway;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import simgsm.console.Arguments;
import simgsm.console.HostPort;
import simgsm.console.UsageException;

/**
 * The gateway's settings, from the command line.
 *
 * @param bind the address of the ports
 * @param hasWeb false if there are only SIP phones, mail and fax
 * @param web the port of the pages; 0 for any free one
 * @param firstNumber of the browsers' numbers
 * @param lastNumber not below the first
 * @param key in the link
 * @param robots addresses of SimRobots' web servers
 * @param sip the port of SIP; 0 for any free one
 * @param sipUsers passwords by number
 * @param mail options of mail, if any is given
 * @param fax options of fax, if any is given
 */
record GatewaySettings(
        InetSocketAddress center,
        InetAddress bind,
        boolean hasWeb,
        int web,
        long firstNumber,
        long lastNumber,
        String key,
        List<URI> robots,
        OptionalInt sip,
        Map<String, String> sipUsers,
        Optional<MailOptions> mail,
        Optional<FaxOptions> fax,
        Locale language) {
    private static final HostPort DEFAULT_CENTER = new HostPort("127.0.0.1", 3003);
    private static final int MAX_PORT = 0xffff;
    private static final int KEY_OCTETS = 8;
    private static final Path DEFAULT_DATA = Path.of("gateway-data");
    private static final String DEFAULT_NUMBERS = "5550110-5550159";

    static GatewaySettings of(Arguments arguments) throws UsageException, IOException {
        HostPort center = arguments.hostPort("center").orElse(DEFAULT_CENTER);
        Optional<MailOptions> mail = MailOptions.of(arguments);
        Optional<FaxOptions> fax = FaxOptions.of(arguments);
        if (fax.isPresent()
                && mail.isPresent()
                && fax.get()
                        .number()
                        .digits()
                        .startsWith(mail.get().settings().bind().number().digits())) {
            throw new UsageException(
                    "--mail-number and --fax-number must be two numbers, and --fax-number not begin with"
                            + " --mail-number, as the numbers of mails do");
        }
        long[] numbers = arguments.value("numbers", GatewaySettings::numbers).orElseGet(() -> numbers(DEFAULT_NUMBERS));
        return new GatewaySettings(
                new InetSocketAddress(center.host(), center.port()),
                arguments.bindAddress(),
                arguments.has("web") || !arguments.has("sip") && mail.isEmpty() && fax.isEmpty(),
                (int) arguments.integer("web", 0, 0, MAX_PORT),
                numbers[0],
                numbers[1],
                arguments.value("key", GatewaySettings::key).orElseGet(GatewaySettings::randomKey),
                arguments.value("robots", GatewaySettings::robots).orElse(List.of()),
                arguments.has("sip")
                        ? OptionalInt.of((int) arguments.integer("sip", 0, 0, MAX_PORT))
                        : OptionalInt.empty(),
                arguments.has("sip") ? SipUserFile.read(arguments.path("data").orElse(DEFAULT_DATA)) : Map.of(),
                mail,
                fax,
                arguments.language());
    }

    private static long[] numbers(String text) {
        if (!text.matches("[1-9][0-9]{0,9}-[1-9][0-9]{0,9}")) {
            throw new IllegalArgumentException("expected FROM-TO, two numbers of 1 to 10 digits, found " + text);
        }
        long[] ends = Arrays.stream(text.split("-")).mapToLong(Long::parseLong).toArray();
        if (ends[1] < ends[0]) {
            throw new IllegalArgumentException("expected FROM-TO with TO not below FROM, found " + text);
        }
        return ends;
    }

    private static String key(String text) {
        if (!text.matches("[0-9A-Za-z_-]{1,64}")) {
            throw new IllegalArgumentException("expected 1 to 64 letters, digits, - or _, found " + text);
        }
        return text;
    }

    private static String randomKey() {
        byte[] octets = new byte[KEY_OCTETS];
        new SecureRandom().nextBytes(octets);
        return HexFormat.of().formatHex(octets);
    }

    private static List<URI> robots(String text) {
        return Arrays.stream(text.split(",")).map(GatewaySettings::robot).toList();
    }

    private static URI robot(String text) {
        URI uri = URI.create(text.endsWith("/") ? text : text + "/");
        if (!"http".equals(uri.getScheme())
                || uri.getHost() == null
                || !uri.getPath().equals("/")) {
            throw new IllegalArgumentException("expected http://HOST:PORT of a SimRobot, found " + text);
        }
        return uri;
    }
}
