// The stand-in for the shield's library has no shield.
#pragma once
