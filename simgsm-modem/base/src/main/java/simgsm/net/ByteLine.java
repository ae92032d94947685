package simgsm.net;

import java.io.IOException;
import java.nio.channels.ByteChannel;

/** A line of octets both ways that can be opened again and again; its text is for logs. */
public interface ByteLine {
    /** Connects; blocks the calling thread. */
    ByteChannel open() throws IOException;
}
