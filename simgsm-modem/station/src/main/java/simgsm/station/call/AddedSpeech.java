package simgsm.station.call;

/** Speech from elsewhere that a station sends in a call beside its own; its frames are the clock of both. */
public interface AddedSpeech {
    /** Nothing is added. */
    AddedSpeech NONE = new AddedSpeech() {
        @Override
        public int framesDue() {
            return 1;
        }

        @Override
        public short[] addTo(short[] own) {
            return own;
        }
    };

    /** The number of frames to be sent now; asked every 20 ms: 0 while the next is late, more once it has come. */
    int framesDue();

    /** The next 20 ms, with those of the station. */
    short[] addTo(short[] own);
}
