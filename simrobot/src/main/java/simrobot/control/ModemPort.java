package simrobot.control;

/** Requests of a robot's control to its modem; callable on any thread. */
interface ModemPort {
    /**
     * Sends a tone.
     *
     * @param call number of the tone's call; the tone is dropped if that call has ended
     * @param key of the telephone
     */
    void sendTone(long call, char key);

    /** Says a reply in words after its tone, if the modem speaks; parameters as for {@link #sendTone}. */
    void say(long call, String reply);

    /** Listens for an order by voice. @return false if the modem takes none */
    boolean listen(long call);

    /** Clears this call, and no later one, after the tones requested so far. */
    void clearCall(long call);

    /** @return false if {@code to} is not a valid number for a short message */
    boolean sendMessage(String to, String text);

    /** Pauses the modem's idle timer during an order. */
    void setOrderUnderWay(boolean underWay);
}
