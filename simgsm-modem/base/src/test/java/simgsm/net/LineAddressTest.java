package simgsm.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.channels.ByteChannel;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class LineAddressTest {
    @Test
    void hostAndPortAreOneOverTcp() {
        assertEquals(new LineAddress.Tcp("robot.example", 8101), LineAddress.parse("robot.example:8101"));
        assertEquals(new LineAddress.Tcp("::1", 8101), LineAddress.parse("[::1]:8101"));
        assertEquals("[::1]:8101", LineAddress.parse("[::1]:8101").toString());
        assertEquals(
                "127.0.0.1:3003",
                LineAddress.of(new InetSocketAddress("127.0.0.1", 3003)).toString());
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void aDeviceFileThatIsThereIsASerialLine() {
        assertEquals(new LineAddress.Device(Path.of("/dev/null")), LineAddress.parse("/dev/null"));
    }

    @Test
    void aRegularFileIsRefusedBecauseItWouldBeOverwritten(@TempDir Path folder) throws Exception {
        Path notes = Files.writeString(folder.resolve("notes.txt"), "my notes");
        IllegalArgumentException refusal =
                assertThrows(IllegalArgumentException.class, () -> LineAddress.parse(notes.toString()));
        assertEquals(
                "expected HOST:PORT or a serial line's device file, found " + notes
                        + ", a regular file, which would be overwritten",
                refusal.getMessage());
        assertEquals("my notes", Files.readString(notes));
    }

    @Test
    void aTcpLineIsOpened() throws Exception {
        try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
                ByteChannel line =
                        LineAddress.parse("127.0.0.1:" + server.getLocalPort()).open();
                Socket peer = server.accept()) {
            peer.getOutputStream().write('A');
            ByteBuffer octet = ByteBuffer.allocate(1);
            assertEquals(1, line.read(octet));
            assertEquals('A', octet.get(0));
        }
    }

    @Test
    void aDeviceIsReadAndWrittenByTheSameName(@TempDir Path folder) throws Exception {
        Path device = Files.writeString(folder.resolve("ttyUSB0"), "OK");
        LineAddress address = new LineAddress.Device(device);
        assertEquals(device.toString(), address.toString());
        try (ByteChannel line = address.open()) {
            ByteBuffer octets = ByteBuffer.allocate(2);
            assertEquals(2, line.read(octets));
            assertEquals(2, line.write(ByteBuffer.wrap(new byte[] {'A', 'T'})));
            assertTrue(line.isOpen());
        }
        assertEquals("AT", Files.readString(device));
        Files.delete(device);
        assertThrows(NoSuchFileException.class, address::open);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "nonsense",
                "host:",
                ":8101",
                "host:0",
                "host:65536",
                "nohost:1:2",
                "::1:8101",
                "/dev/no-such-line",
                "/"
            })
    void anythingElseIsRefusedInWords(String text) {
        IllegalArgumentException refusal = assertThrows(IllegalArgumentException.class, () -> LineAddress.parse(text));
        assertTrue(refusal.getMessage().startsWith("expected HOST:PORT or a serial line's device file, found "));
    }
}
