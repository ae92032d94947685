package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Messages that become fax pages: a phone's, those of an SMSC that repeats them, and the options. */
class FaxTest {
    private static final int DELIVER_SM = 5;
    private static final int RESPONSE = 0x8000_0000;
    private static final int TEMPORARY_ERROR = 0x64;
    private static final int PERMANENT_ERROR = 0x65;

    @TempDir
    Path folder;

    private Path faxes() {
        return folder.resolve("faxes");
    }

    private List<Path> files() throws IOException {
        try (Stream<Path> files = Files.list(faxes())) {
            return files.sorted().toList();
        }
    }

    @Test
    void aPhonesMessageIsAPageBeforeItIsDelivered() throws Exception {
        try (Scenario scenario = new Scenario("fax")) {
            scenario.center("--smpp", "0");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            RunningProgram gateway = scenario.faxGateway(scenario.smppPort(), faxes());
            gateway.expect("ready");
            gateway.say("users").expect("user", "kind", "fax", "number", "6329", "state", "idle");
            phone.say("sms 6329 Hello");
            ConsoleEvent fax = gateway.expect("fax", "to", "6329");
            phone.expect("sms-delivered", "to", "6329");
            Path file = faxes().resolve("fax-" + fax.field("id") + ".tif");
            assertEquals(file.toString(), fax.field("file"));
            BufferedImage page = ImageIO.read(file.toFile());
            assertEquals(1728, page.getWidth());

            scenario.tell("the parts of a long message are one page, for the receiver in front of its text");
            phone.say("sms 6329 +34555999900 " + "0123456789".repeat(40));
            gateway.expect("fax", "to", "+34555999900");
            assertEquals(2, files().size());
            assertEquals(0, gateway.quit());
        }
    }

    @Test
    void aGatewayThatIsKilledAmongMessagesWritesOneFileForEach() throws Exception {
        try (Scenario scenario = new Scenario("fax, killed")) {
            scenario.center("--smpp", "0");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            RunningProgram gateway = scenario.faxGateway(scenario.smppPort(), faxes());
            gateway.expect("ready");
            for (int i = 0; i < 30; i++) {
                phone.say("sms 6329 Message " + i);
                if (i % 10 == 5) {
                    gateway.expect("fax");
                    gateway.kill();
                    gateway = scenario.faxGateway(scenario.smppPort(), faxes());
                    gateway.expect("ready");
                }
            }
            for (int i = 0; i < 30; i++) {
                phone.expect("sms-delivered");
            }
            assertEquals(
                    30,
                    files().stream()
                            .filter(file -> file.toString().endsWith(".tif"))
                            .count());
        }
    }

    /** An SMSC, written from SMPP 3.4 alone, with one bound application. */
    private static final class Smsc implements AutoCloseable {
        private final Socket socket;
        private final DataInputStream in;

        Smsc(ServerSocket port) throws IOException {
            socket = port.accept();
            socket.setSoTimeout(RunningProgram.PATIENCE_SECONDS * 1_000);
            in = new DataInputStream(socket.getInputStream());
            int[] bind = read();
            send(bind[1] | RESPONSE, bind[3], new byte[1]);
        }

        /** Length, command, status and sequence number of the next PDU. */
        private int[] read() throws IOException {
            int[] header = {in.readInt(), in.readInt(), in.readInt(), in.readInt()};
            in.skipNBytes(header[0] - 16L);
            return header;
        }

        private void send(int command, int sequence, byte[] body) throws IOException {
            ByteBuffer pdu = ByteBuffer.allocate(16 + body.length);
            pdu.putInt(pdu.capacity())
                    .putInt(command)
                    .putInt(0)
                    .putInt(sequence)
                    .put(body);
            socket.getOutputStream().write(pdu.array());
        }

        /** Delivers a text of ASCII; returns the status that answers it. */
        int deliver(int reference, String text) throws IOException {
            ByteArrayOutputStream body = new ByteArrayOutputStream();
            body.writeBytes("\0\1\0015550100\0\1\0016329\0\0\0\0\0\0\0\0\3\0\0".getBytes(StandardCharsets.ISO_8859_1));
            byte[] octets = text.getBytes(StandardCharsets.US_ASCII);
            body.writeBytes(new byte[] {4, 0x24, (byte) (octets.length >> 8), (byte) octets.length});
            body.writeBytes(octets);
            body.writeBytes(new byte[] {2, 4, 0, 2, 0, (byte) reference});
            send(DELIVER_SM, reference, body.toByteArray());
            int[] answer = read();
            assertEquals(DELIVER_SM | RESPONSE, answer[1]);
            assertEquals(reference, answer[3]);
            return answer[2];
        }

        @Override
        public void close() throws IOException {
            socket.close();
        }
    }

    @Test
    void aDiskThatTakesNoFileIsATemporaryErrorAndARepeatedMessageIsTheSameFile() throws Exception {
        try (Scenario scenario = new Scenario("fax, repeated");
                ServerSocket port = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            RunningProgram gateway = scenario.faxGateway(port.getLocalPort(), faxes());
            try (Smsc smsc = new Smsc(port)) {
                gateway.expect("ready");
                Files.delete(faxes());
                assertEquals(TEMPORARY_ERROR, smsc.deliver(1, "Hello"));
                String why = gateway.expect("fax-failed", "to", "6329").field("text");
                assertTrue(why.contains(faxes() + ""), why);
                Files.createDirectory(faxes());
                assertEquals(0, smsc.deliver(1, "Hello"));
                assertEquals(0, smsc.deliver(1, "Hello"), "from memory");
                gateway.kill();
            }
            assertEquals(1, files().size());

            scenario.tell("a gateway that was killed before its answer writes the file again");
            RunningProgram second = scenario.faxGateway(port.getLocalPort(), faxes());
            try (Smsc smsc = new Smsc(port)) {
                assertEquals(0, smsc.deliver(1, "Hello"));
                second.expect("fax", "to", "6329");
                assertEquals(1, files().size());
                assertEquals(0, smsc.deliver(2, "Hello"));
                assertEquals(2, files().size());
                assertEquals(PERMANENT_ERROR, smsc.deliver(3, "\f".repeat(50)), "51 pages");
                second.expect("fax-failed", "text", "over 50 pages");
            }
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--fax-number 6329|fax needs --smpp, --fax-number and --fax; --smpp is missing",
                "--smpp h:1 --fax d|fax needs --smpp, --fax-number and --fax; --fax-number is missing",
                "--smpp h:1 --fax-number 6329|fax needs --smpp, --fax-number and --fax; --fax is missing",
                "--smpp h:1 --fax-number x --fax FOLDER|\"x\" is not a telephone number",
                "--smpp h:1 --fax-number 6329 --fax FOLDER --numbers x|expected FROM-TO",
                "--smpp h:1 --fax-number 6329 --fax FILE|there is a file of that name",
                "--smpp h:1 --fax-number 1 --fax FOLDER --mail-number 1 --mail-domain d --mail-in 0|must be two numbers",
                "--smpp h:1 --fax-number 62 --fax FOLDER --mail-number 6 --mail-domain d --mail-in 0|not begin with --mail-number",
            })
    void aMissingOrWrongOptionIsNamed(String options, String text) throws Exception {
        Path file = Files.createFile(folder.resolve("file"));
        String[] words = ("--headless " + options)
                .replace("FOLDER", faxes().toString())
                .replace("FILE", file.toString())
                .split(" ");
        FinishedProgram gateway = FinishedProgram.run("simgsm-gateway", words);
        assertTrue(gateway.status() > 0);
        assertTrue(gateway.error().contains(text), gateway.error());
        assertFalse(Files.exists(faxes()), "made after the checks of the options");
    }
}
